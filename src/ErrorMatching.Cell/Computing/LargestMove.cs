using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The largest displacement of a correction, by which the correction is judged. A trial and a stored correction use the same
/// calculation and so agree.</summary>
/// <param name="Mm">The largest displacement in mm; 0 if nothing moves.</param>
/// <param name="At">Where that is: <c>point 5 of C1</c>, <c>block N170</c>; empty if nothing moves.</param>
/// <param name="Block">The block concerned; null for none.</param>
public sealed record LargestMove(double Mm, Statement At, string? Block)
{
    /// <summary>The largest displacement of a match: at a key point, or between or next to key points if a block must move further
    /// there.</summary>
    /// <param name="matched">The match.</param>
    public static LargestMove Of(MatchedProgram matched)
    {
        ArgumentNullException.ThrowIfNull(matched);
        var largest = new LargestMove(0, "", null);
        if (matched.Match.Correction is { IsOffset: true } offset)
        {
            return OffsetMove.Largest(matched.Match, offset.StepRadiusMm, offset.StepMove);
        }

        if (matched.Match.Rewrite is null)
        {
            return largest;
        }

        foreach (var point in matched.Report.KeyPoints)
        {
            var mm = new PointCorrection(point.Point, point.Correction.X, point.Correction.Y, 0).LengthMm;
            largest = mm > largest.Mm
                ? new(mm, Recorded.AtPointOf.With(point.Point, point.Feature), point.Blocks.Count > 0 ? point.Blocks[0] : null)
                : largest;
        }

        // Between and next to the points a block may have to move further than they do. Rounding alone does not count.
        var (before, increment) = (matched.Match.Before, matched.Match.LeastIncrementMm);
        foreach (var element in matched.Match.Wish!.Elements)
        {
            var mm = Math.Max(element.Start.Length, Math.Max(element.Middle.Length, element.End.Length));
            if (mm > largest.Mm + increment)
            {
                var name = before.Program.NameOf(before.Program[before.Motions[element.Motion].Block]);
                largest = new(mm, Recorded.AtBlock.With(name), name);
            }
        }

        return largest;
    }
}
