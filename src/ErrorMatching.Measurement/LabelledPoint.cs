using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>A measured point with its name from the gauge and its line in the file.</summary>
/// <param name="Label">Name of the point, without surrounding spaces. Case-sensitive.</param>
/// <param name="Position">Position in millimeters, in the frame of the gauge; Z is 0 if the file has none.</param>
/// <param name="HasZ">True if the file contains a Z.</param>
/// <param name="Line">Line of the file, from 1; of the first coordinate if a point has several lines.</param>
public readonly record struct LabelledPoint(string Label, Point3 Position, bool HasZ, int Line);
