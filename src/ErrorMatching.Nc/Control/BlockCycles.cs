using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Cycles that a G code runs once, in its block: patterns of bolt holes, which are followed, and pockets, engraving, measuring
/// and homing, which are not.</summary>
internal sealed class BlockCycles(NcControl control, Corners corners, CannedCycles canned)
{
    private const double FullCircle = 360;

    /// <summary>Runs the cycle of the block.</summary>
    public void Run(MotionFlags flags)
    {
        corners.Lose();
        control.Result.DependOnPlace();
        if (control.Intent.Code is NcMeaning.BoltCircle or NcMeaning.BoltArc or NcMeaning.BoltLine && Places() is { } places)
        {
            canned.DrillAt(flags, places);

            // Whether it returns to the center depends on the control.
            control.State.Unknown |= control.State.Plane.Axes();
            return;
        }

        control.Result.Note("cycle-not-followed", $"{NameOfCode()} is not followed: what it does is the control's affair.");
        control.Moves.Append(MotionKind.Cycle, flags | MotionFlags.Cycle, control.State.Position, AxisSet.All);
        if (control.Intent.Code == NcMeaning.Unsure)
        {
            control.Layers.Forget();
        }
    }

    // Haas G70: radius I, angle of the first hole J, number L. G71 has the angle K from hole to hole instead of a full circle. G72 has
    // the distance I from hole to hole along a line at the angle J. Null if they are not stated, or if only the machine knows how they are
    // read.
    private List<Point2>? Places()
    {
        var words = control.Words;
        var isArc = control.Intent.Code == NcMeaning.BoltArc;
        var needed = BlockWords.Bit('I') | BlockWords.Bit('L') | (isArc ? BlockWords.Bit('K') : 0);
        var plane = control.State.Plane;
        var (center, unknown) = control.Moves.Target();
        var isKnown = canned.CanDrillAt
            && plane == CoordinatePlane.XY
            && (words.Present & needed) == needed
            && ((words.Unknown | words.Repeated) & (needed | BlockWords.Bit('J'))) == 0
            && (unknown & plane.Axes()) == AxisSet.None
            && IsPlainAngle('J')
            && (!isArc || IsPlainAngle('K'));
        var number = words.Has('L') ? words.Value('L') : 0;
        if (!isKnown || !(number is >= 1 and <= ProgramRun.MostHoles) || number != Math.Floor(number))
        {
            return null;
        }

        var step = isArc ? words.Value('K') : FullCircle / number;
        var first = words.Has('J') ? words.Value('J') : 0;
        var (length, isLine, start) = (control.Values.Length('I'), control.Intent.Code == NcMeaning.BoltLine, plane.Project(center));
        var places = new List<Point2>((int)number);
        for (var i = 0; i < number; i++)
        {
            var direction = Vector2.FromDirection(Angle.FromDegrees(isLine ? first : first + (i * step)));
            var from = direction * (isLine ? i * length : length);
            places.Add(new(BlockValues.Sum(start.X, from.X), BlockValues.Sum(start.Y, from.Y)));
        }

        return places;
    }

    // A setting of the control can make an angle without a point count thousandths.
    private bool IsPlainAngle(char letter) =>
        !control.Words.Has(letter) || (control.Words.Integers & BlockWords.Bit(letter)) == 0 || control.Words.Value(letter) == 0;

    private string NameOfCode()
    {
        foreach (var tenths in control.Words.Codes)
        {
            if (control.Dialect.MeaningOf(tenths) == control.Intent.Code)
            {
                return "G" + (tenths / 10m).ToString(CultureInfo.InvariantCulture);
            }
        }

        return "A word of the block";
    }
}
