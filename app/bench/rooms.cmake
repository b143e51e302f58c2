# Level 7, beside the window: what `pointclay bench` and tests/bench measure, and the naive ways beside it. The only
# room that knows Eigen.
find_package(Eigen3 REQUIRED NO_MODULE)
pointclay_room(workloads app/bench gl session)
pointclay_link(workloads nanoflann::nanoflann Eigen3::Eigen)
