// All frames, in the order in which they are listed everywhere (surface/README 2.4): enumerator, name in files and on
// the command line, and what else differs from the defaults of FrameRow (frame_table.h). The functions of a frame are
// in the file of its name; a new one needs that file and a row here, nothing else.
POINTCLAY_FRAME(Normals, "normals", .reads = NormalsRead::Oriented, .solids = true)
POINTCLAY_FRAME(Hyperplanes, "hyperplanes", .reads = NormalsRead::Unoriented, .outer = Outer::Normals)
POINTCLAY_FRAME(Covariance, "covariance", .outer = Outer::Offsets, .onCurves = true, .distance = false)
POINTCLAY_FRAME(CovarianceAtCentroid, "covariance-at-centroid", .onCurves = true)
POINTCLAY_FRAME(CentroidGradient, "centroid-gradient", .onCurves = true)
POINTCLAY_FRAME(Apss, "apss", .reads = NormalsRead::Oriented, .ownField = true)
POINTCLAY_FRAME(Rimls, "rimls", .reads = NormalsRead::Oriented, .ownField = true)
