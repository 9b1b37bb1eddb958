using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The grid of numbers that a program can express. A joint's displacement is rounded to it once.</summary>
/// <param name="change">New joints.</param>
/// <param name="isInch">True if the words are in inches.</param>
/// <param name="decimals">Decimals of the words.</param>
internal sealed class IncrementGrid(PathChange change, bool isInch, int decimals)
{
    /// <summary>True if the words are in inches.</summary>
    public bool IsInch => isInch;

    /// <summary>Decimals of the words.</summary>
    public int Decimals => decimals;

    /// <summary>The unit of the words, mm.</summary>
    public double Unit { get; } = isInch ? 25.4 : 1;

    /// <summary>The least increment, mm.</summary>
    public double Increment { get; } = Math.Pow(10, -decimals) * (isInch ? 25.4 : 1);

    /// <summary>The displacement of a joint along an axis, in increments.</summary>
    public long Steps(int joint, byte axis) =>
        NcNumber.Round(Coordinate(default(Point3) + change.MoveOf(joint), axis) / Increment, 0).Digits;

    /// <summary>A number of increments as a number of a word.</summary>
    public NcNumber Number(long steps) => new(steps, decimals);

    /// <summary>A place after the rounded displacement of a joint.</summary>
    public Point2 Rounded(Point3 place, int joint, CoordinatePlane plane) =>
        plane.Project(new(
            place.X + (Steps(joint, (byte)'X') * Increment),
            place.Y + (Steps(joint, (byte)'Y') * Increment),
            place.Z + (Steps(joint, (byte)'Z') * Increment)));

    /// <summary>A coordinate of a place.</summary>
    public static double Coordinate(Point3 point, byte axis) => axis switch { (byte)'X' => point.X, (byte)'Y' => point.Y, _ => point.Z };
}
