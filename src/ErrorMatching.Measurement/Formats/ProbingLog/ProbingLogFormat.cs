using System.Globalization;

namespace ErrorMatching.Measurement;

/// <summary>The log of a probing program of ours: a line that names its plan, a line for each touch (<see cref="ProbedLine"/>), and
/// <c>END</c>. The points have the numbers of the plan's order, and each says whether it is a center or a contact.</summary>
internal sealed class ProbingLogFormat : SelfDescribingFormat
{
    /// <inheritdoc/>
    public override bool Recognizes(MeasurementBytes source, string head) =>
        LogLines.OfHead(head).FirstOrDefault(l => !IsOfControl(l))?.StartsWith("ERRORMATCH PROBE", StringComparison.Ordinal) == true;

    /// <inheritdoc/>
    public override MeasuredContent Read(MeasurementBytes source, MeasurementFormat format)
    {
        var points = new LogPoints(source.File, LengthUnit.Millimeter);
        var (plan, ended, centers) = ((string?)null, (TextLine?)null, new HashSet<int>());
        var touches = new SortedDictionary<int, (ProbedLine Touch, TextLine Line)>();
        foreach (var line in LogLines.Of(source, format).Where(l => !IsOfControl(l.Text)))
        {
            if (line.Text.StartsWith("ERRORMATCH", StringComparison.Ordinal))
            {
                plan = plan is null
                    ? PlanOf(line)
                    : throw line.Fail(
                        MeasurementError.SeveralMeasurements,
                        "a second run of the probing program",
                        "one run in a file: delete all but the one that counts");
            }
            else if (ended is { } end)
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    $"{MeasurementRefusal.Quote(line.Text)} behind {ProbedLine.End} in line {end.Number}",
                    "nothing more");
            }
            else if (line.Text == ProbedLine.End)
            {
                ended = line;
            }
            else if (ProbedLine.Read(line.Text, out var read) is not { } touch)
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    MeasurementRefusal.Quote(line.Text),
                    $"a point such as {ProbedLine.Example}, as the probing program writes it",
                    read + 1);
            }
            else if (!touches.TryAdd(touch.Number, (touch, line)))
            {
                throw line.Fail(
                    MeasurementError.DuplicatePoint,
                    $"the point P{touch.Number} again",
                    $"each point once: line {touches[touch.Number].Line.Number} has this one already");
            }
        }

        var expected = 0;
        foreach (var (number, (touch, line)) in touches)
        {
            // Numbers in the order of the plan, from 1: a gap is a point that was not touched.
            expected++;
            if (number != expected)
            {
                throw line.Fail(
                    MeasurementError.MissingPoint,
                    $"the point P{number} after {expected - 1} others",
                    $"the point P{expected}: measure it");
            }

            var cell = line.Cell(line.Text, 1, "of the point");
            foreach (var value in new[] { touch.Position.X, touch.Position.Y, touch.Position.Z })
            {
                Coordinate.Checked(value, cell with { Text = value.ToString(CultureInfo.InvariantCulture) });
            }

            points.Add(null, touch.Position, true, cell);
            if (touch.IsCenter)
            {
                centers.Add(line.Number);
            }
        }

        return points.Content(isByOrder: true) with { Plan = plan, Centers = centers };
    }

    // Lines of the control's own around the log.
    private static bool IsOfControl(string line) => line is ['%' or ';', ..];

    private static string PlanOf(TextLine line)
    {
        var words = line.Text.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        return words is ["ERRORMATCH", "PROBE", "PLAN", var plan, "MM"] ? plan
            : throw line.Fail(
                MeasurementError.BadStructure, MeasurementRefusal.Quote(line.Text), $"{ProbedLine.Head}, the plan's number, and MM");
    }
}
