using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>A point of a measurement with the name that the gauge gave it and the line it was read from.</summary>
/// <param name="Label">Name of the point, without the spaces around it. Upper and lower case differ.</param>
/// <param name="Position">Place in millimeters, in the frame of the gauge; Z is 0 where the file has none.</param>
/// <param name="HasZ">True if the file gave a Z.</param>
/// <param name="Line">Line of the file, counted from 1; of the first coordinate where a point takes several lines.</param>
public readonly record struct LabelledPoint(string Label, Point3 Position, bool HasZ, int Line);
