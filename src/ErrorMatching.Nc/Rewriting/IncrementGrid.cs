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
    public double Increment { get; } = Size(isInch, decimals);

    /// <summary>The least increment of some blocks, mm.</summary>
    /// <param name="path">The path.</param>
    /// <param name="motions">The motions of the blocks, at least one.</param>
    public static double Of(NcPath path, List<int> motions)
    {
        var isInch = path.Motions[motions[0]].Has(MotionFlags.Inch);
        var least = isInch ? path.Dialect.InchDecimals : path.Dialect.MetricDecimals;
        return Size(isInch, Spelling(path, motions, motions.Count, least).Decimals);
    }

    /// <summary>The decimals of the words in some blocks, at least those of the control's least increment, and whether words are written
    /// with all decimals.</summary>
    public static (int Decimals, bool IsFixed) Spelling(NcPath path, List<int> motions, int count, int leastDecimals)
    {
        var spelling = (leastDecimals, false);
        for (var i = 0; i < count; i++)
        {
            foreach (ref readonly var token in path.Program.Tokens(path.Program[path.Motions.BlockOf(motions[i])]))
            {
                spelling = BlockEdit.SpellingWith(spelling, token);
            }
        }

        return spelling;
    }

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

    private static double Size(bool isInch, int decimals) => Elementary.Pow(10, -decimals) * (isInch ? 25.4 : 1);

    /// <summary>A coordinate of a place.</summary>
    public static double Coordinate(Point3 point, byte axis) => axis switch { (byte)'X' => point.X, (byte)'Y' => point.Y, _ => point.Z };
}
