# Level 7, beside the window: what `pointclay bench` and tests/bench measure, and the naive ways beside it.
find_package(embree 3 REQUIRED)
pointclay_room(workloads app/bench gl session haptics)

# The naive ways are built as well as the compiler can for the machine that builds: whoever compares must not lose by
# flags. A Release taken to another machine runs there, but for the rows of `pointclay bench` that need these.
# Under sanitizers they are files like all others.
file(GLOB naive CONFIGURE_DEPENDS app/bench/naive/*.cpp)
if(POINTCLAY_SANITIZE)
    pointclay_link(workloads nanoflann::nanoflann Eigen3::Eigen embree)
else()
    get_target_property(sources pointclay_workloads SOURCES)
    list(REMOVE_ITEM sources ${naive})
    set_target_properties(pointclay_workloads PROPERTIES SOURCES "${sources}")
    add_library(pointclay_naive OBJECT ${naive})
    target_include_directories(pointclay_naive PRIVATE $<TARGET_PROPERTY:pointclay_workloads,INCLUDE_DIRECTORIES>)
    target_link_libraries(pointclay_naive PRIVATE nanoflann::nanoflann Eigen3::Eigen embree)
    target_compile_options(pointclay_naive PRIVATE -O3 -march=native -ffp-contract=fast -ftree-slp-vectorize)
    set(sealed ${CMAKE_BINARY_DIR}/naive_sealed.o)
    add_custom_command(OUTPUT ${sealed}
        COMMAND ${CMAKE_SOURCE_DIR}/app/bench/seal ${sealed} $<TARGET_OBJECTS:pointclay_naive>
        DEPENDS pointclay_naive $<TARGET_OBJECTS:pointclay_naive> ${CMAKE_SOURCE_DIR}/app/bench/seal
        COMMAND_EXPAND_LISTS VERBATIM)
    set_source_files_properties(${sealed} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
    target_sources(pointclay_workloads PRIVATE ${sealed})
    target_link_libraries(pointclay_workloads PUBLIC embree)
endif()
