using System.Globalization;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The forms of what the cell states about corrections by offsets of the control.</summary>
public static class RecordedOffset
{
    private const string Length = "0.0000";
    private const string Turn = "0.000000";

    /// <summary>A radius offset: its number, the step and the correction in all, mm.</summary>
    public static SentenceForm Radius { get; } = new(
        "offset-radius", $"offset of the control: radius D{{0:0}} by {{1:{Length}}} mm, {{2:{Length}}} mm in all.");

    /// <summary>A radius offset of a control whose offsets belong to tools: tool, number, the step and the correction in all, mm.</summary>
    public static SentenceForm RadiusOfTool { get; } = new(
        "offset-radius-of-tool",
        $"offset of the control: radius of tool {{0:0}}, D{{1:0}}, by {{2:{Length}}} mm, {{3:{Length}}} mm in all.");

    /// <summary>A work offset: its number, then X and Y of the step and of the correction in all, mm.</summary>
    public static SentenceForm Work { get; } = new(
        "offset-work",
        $"offset of the control: work offset {{0:0}} by X {{1:{Length}}} Y {{2:{Length}}} mm, X {{3:{Length}}} Y {{4:{Length}}} mm "
            + "in all.");

    /// <summary>A work offset that turns, too: its number, then X, Y and rotation of the step and of the correction in all, mm and
    /// degrees.</summary>
    public static SentenceForm WorkTurned { get; } = new(
        "offset-work-turned",
        $"offset of the control: work offset {{0:0}} by X {{1:{Length}}} Y {{2:{Length}}} mm and {{3:{Turn}}} degrees, X {{4:{Length}}} "
            + $"Y {{5:{Length}}} mm and {{6:{Turn}}} degrees in all.");

    internal static readonly SentenceForm NotWritten = new(
        "offset-not-written",
        "The job {0} allows offsets alone, and the program does not tell which offset of the control its features are cut with. State "
            + "radiusOffset in the job, or allow another offset.");

    internal static readonly SentenceForm SlotOfPrograms = new(
        "slot-of-programs",
        "{0} at {1} is the program of correction {2:0}, which cuts: a program that sets offsets does not replace it. Give the offsets a "
            + "slot of their own.");

    internal static readonly SentenceForm KindChanged = new(
        "correction-kind-changed",
        "Correction {0:0} of the job {1} was made by other means: by an offset of the control where this one rewrites the program, or by "
            + "blocks where this one sets an offset. Both together would correct twice. Take that correction back at the machine: revert "
            + "it, and run what that sends if it is an offset. Then give the job another name in the configuration.");

    internal static readonly SentenceForm StepTooLarge = new(
        "offset-step-too-large",
        $"The offset would go from {{0:{Length}}} to {{1:{Length}}} mm, and the job allows {{2:{Length}}} mm in a step: the program would "
            + "stop at the machine. Revert correction {3:0} and run what that sends, then approve this one again; or reject this one.");

    internal static readonly SentenceForm TurnTooLarge = new(
        "offset-turn-too-large",
        $"The rotation would go from {{0:{Turn}}} to {{1:{Turn}}} degrees, and the job allows {{2:{Turn}}} degrees in a step: the program "
            + "would stop at the machine. Revert correction {3:0} and run what that sends, then approve this one again; or reject this "
            + "one.");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } =
        [Radius, RadiusOfTool, Work, WorkTurned, NotWritten, SlotOfPrograms, KindChanged, StepTooLarge, TurnTooLarge];

    /// <summary>What the program of a choice sets: each offset, the step and the correction in all.</summary>
    /// <param name="choice">The choice.</param>
    public static Statement Of(CorrectionChoice choice) => Statement.InARow(new[]
    {
        choice.Radius is { } radius ? Of(radius) : null,
        choice.Work is { } work ? Of(work.Number, work.Total, work.Before ?? default) : null,
    }.OfType<Statement>());

    /// <summary>The corrections in all that a program sets, each with a name of its own: in mm, or of a rotation in degrees.</summary>
    /// <param name="offset">What <see cref="Of(CorrectionChoice)"/> stated.</param>
    internal static IEnumerable<(string Name, decimal Total, bool IsAngle)> Totals(Statement offset)
    {
        foreach (var part in offset.Parts)
        {
            var values = part.Values.Select(v => v.Words ?? "").ToArray();
            if (part.Is(Radius)) yield return ($"radius {values[0]}", Number(2), false);
            if (part.Is(RadiusOfTool)) yield return ($"radius {values[1]} of tool {values[0]}", Number(3), false);
            if (!part.Is(Work) && !part.Is(WorkTurned)) continue;
            var first = part.Is(Work) ? 3 : 4;
            yield return ($"X of work offset {values[0]}", Number(first), false);
            yield return ($"Y of work offset {values[0]}", Number(first + 1), false);
            yield return ($"rotation of work offset {values[0]}", part.Is(Work) ? 0 : Number(first + 2), true);

            decimal Number(int at) => decimal.Parse(values[at], NumberStyles.Float, CultureInfo.InvariantCulture);
        }
    }

    private static Statement Of(Nc.RadiusCorrection radius)
    {
        var step = radius.TotalMm - (radius.BeforeMm ?? 0);
        return radius.Tool > 0
            ? RadiusOfTool.With(radius.Tool, radius.Number, step, radius.TotalMm)
            : Radius.With(radius.Number, step, radius.TotalMm);
    }

    private static Statement Of(int number, Nc.OffsetShift total, Nc.OffsetShift before)
    {
        var (x, y, turn) = (total.XMm - before.XMm, total.YMm - before.YMm, total.RotationDegrees - before.RotationDegrees);
        return (turn, total.RotationDegrees) == (0, 0)
            ? Work.With(number, x, y, total.XMm, total.YMm)
            : WorkTurned.With(number, x, y, turn, total.XMm, total.YMm, total.RotationDegrees);
    }
}
