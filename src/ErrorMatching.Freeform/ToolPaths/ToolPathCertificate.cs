using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The measurements of the finished path, rounded as in the program, against the exact surface. Lengths in millimeters.</summary>
/// <param name="ChordMm">Largest distance between the polyline of centers and the exact curve of centers, over all passes, sampled at
/// every point and three times between two.</param>
/// <param name="ChordAt">Its place on the surface.</param>
/// <param name="ScallopMm">Greatest height of the material left between passes above the stage's required surface, along its normal:
/// ridge, chords and rounding combined, at least 0. Sampled at the points of both passes and halfway between.</param>
/// <param name="ScallopAt">Its place on the surface.</param>
/// <param name="GougeMm">By how much a center may be nearer to the surface than radius plus stock; none is nearer anywhere.</param>
/// <param name="RaisedPoints">Number of points raised because the ball would have gouged the surface elsewhere.</param>
/// <param name="RaisedMm">Largest height by which a point was raised; about that much more material is left there.</param>
/// <param name="RaisedAt">Its place on the surface.</param>
public sealed record ToolPathCertificate(
    double ChordMm, Point3 ChordAt, double ScallopMm, Point3 ScallopAt, double GougeMm, int RaisedPoints, double RaisedMm, Point3 RaisedAt)
{
    // A chord that is longer lies inside by what a setter would call a gouge.
    private const double SmallChordMm = 0.01;

    /// <summary>True if no gouge was found and the chords are small. A gouge differs from a chord only by its size.</summary>
    public bool HasNoGouge => RaisedPoints == 0 && ChordMm <= SmallChordMm;
}
