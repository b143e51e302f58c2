# The level list of core/README.md, as the build sees it: each room names the rooms above it that it may use.
# Third-party libraries are linked privately where their one wrapper lives.
pointclay_room(base core/base)
pointclay_link(base TBB::tbb Threads::Threads Eigen3::Eigen)

pointclay_room(surfel core/surfel base)

pointclay_room(tree core/tree surfel)
pointclay_link(tree PkgConfig::HWY)

pointclay_room(surface core/surface tree)
pointclay_link(surface PkgConfig::HWY)
# As for sculpt below.
set_source_files_properties(core/surface/winding/surfel_areas.cpp PROPERTIES
                            COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math"
                            SKIP_PRECOMPILE_HEADERS ON)

pointclay_room(process core/process surface)
pointclay_link(process nanoflann::nanoflann PkgConfig::HWY Eigen3::Eigen)
# As for sculpt below.
set_source_files_properties(core/process/estimation/orientation/normal_links.cpp
                            core/process/estimation/orientation/outside.cpp
                            core/process/estimation/plane_normals.cpp
                            core/process/resampling/repulsion.cpp PROPERTIES
                            COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math"
                            SKIP_PRECOMPILE_HEADERS ON)

pointclay_room(layers core/layers tree)
# As for sculpt below.
target_compile_options(pointclay_layers PRIVATE -fno-math-errno -fno-trapping-math)

pointclay_room(complexes core/complexes surface)

pointclay_room(cells core/cells complexes)

pointclay_room(raycast core/raycast cells)

pointclay_room(mesh core/mesh process cells)
# CGAL is headers over these two. Its own target would set -frounding-math, which its predicates need, for all of the
# room: only those files get it that include CGAL.
pointclay_link(mesh gmp mpfr)
set_source_files_properties(core/mesh/check/self_intersections.cpp PROPERTIES COMPILE_OPTIONS "-frounding-math")

pointclay_room(solid core/solid mesh)
pointclay_link(solid Eigen3::Eigen)

pointclay_room(reduce core/reduce process cells)
pointclay_link(reduce Eigen3::Eigen)

pointclay_room(sculpt core/sculpt process cells layers)
# Neither changes a bit; without them loops with square roots and selections stay scalar.
target_compile_options(pointclay_sculpt PRIVATE -fno-math-errno -fno-trapping-math)

pointclay_room(haptics core/haptics surface)
pointclay_link(haptics nlohmann_json::nlohmann_json)

pointclay_room(io core/io process mesh)
pointclay_link(io PNG::PNG JPEG::JPEG pugixml::pugixml ZLIB::ZLIB EXPAT::EXPAT nlohmann_json::nlohmann_json)

pointclay_room(render core/render raycast io)
pointclay_link(render PkgConfig::HWY PkgConfig::EXR Eigen3::Eigen)

pointclay_room(selection core/selection sculpt render)

pointclay_room(session core/session sculpt haptics reduce solid io selection)
pointclay_link(session nlohmann_json::nlohmann_json)
pointclay_unhurried(pointclay_session)
