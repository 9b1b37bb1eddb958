using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>What was measured on the finished path, its numbers rounded as the program states them, against the exact surface. Lengths in millimetres.</summary>
/// <param name="ChordMm">Largest distance between the polyline of centers and the exact curve of centers, over all passes; sampled at every point and three times between two.</param>
/// <param name="ChordAt">The place on the surface where it is.</param>
/// <param name="ScallopMm">Greatest height of the material left between passes over the surface that the stage asks for, along its normal: ridge, chords and rounding together, and never less than 0; sampled at and half way between the points of both passes.</param>
/// <param name="ScallopAt">The place on the surface where it is.</param>
/// <param name="GougeMm">By how much, at most, a center may be nearer to the surface than radius and stock: no center is nearer than that, anywhere on the surface.</param>
/// <param name="RaisedPoints">Points that were raised because the ball would have cut the surface elsewhere.</param>
/// <param name="RaisedMm">Largest height by which one was raised: about that much more material is left there.</param>
/// <param name="RaisedAt">The place on the surface where it is.</param>
public sealed record ToolPathCertificate(double ChordMm, Point3 ChordAt, double ScallopMm, Point3 ScallopAt, double GougeMm, int RaisedPoints, double RaisedMm, Point3 RaisedAt)
{
    // A chord that is longer lies inside by what a setter would call a gouge.
    private const double SmallChordMm = 0.01;

    /// <summary>True if no gouge was found and chords, which a gouge is told from by their length alone, are so small that there is none.</summary>
    public bool HasNoGouge => RaisedPoints == 0 && ChordMm <= SmallChordMm;
}
