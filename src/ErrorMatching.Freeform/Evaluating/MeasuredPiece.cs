using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The points of a plan with what was measured for each.</summary>
/// <param name="File">The file of the points, as the user named it.</param>
/// <param name="Sha256">SHA-256 of the file's bytes as 64 lower-case hexadecimal digits.</param>
/// <param name="Points">Points of the plan with the point of contact of each, in millimetres.</param>
public sealed record MeasuredPiece(string File, string Sha256, IReadOnlyList<(PlanPoint Plan, Point3 Contact)> Points);
