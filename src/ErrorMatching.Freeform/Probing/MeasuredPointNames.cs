using System.Buffers;
using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the points of a gauge's file as points of a plan, named by number or by place.</summary>
internal sealed class MeasuredPointNames(MeasurementFile file, bool isCenter)
{
    private static readonly SearchValues<char> OfNumbers = SearchValues.Create("-+.,0123456789");

    public IReadOnlyList<RawPoint> Read()
    {
        // A table may have the columns i and j beside the numbers of its points. Then they must agree.
        var (i, j) = (file.ColumnTexts("i"), file.ColumnTexts("j"));
        var isPlaced = i?.Count == file.Points.Count && j?.Count == file.Points.Count;
        return [.. file.Points.Select((p, row) => Read(p, isPlaced ? (i![row], j![row]) : null))];
    }

    private RawPoint Read(LabelledPoint point, (string I, string J)? place)
    {
        if (!point.HasZ)
        {
            throw InputException.At(
                "missing-coordinate",
                file.File,
                $"found no Z of the point {ProbingLogReader.Shown(point.Label)}; expected X, Y and Z.",
                point.Line);
        }

        if (PlaceOf(point.Label) is { } named)
        {
            return new(null, named.I, named.J, point.Position, isCenter, point.Line);
        }

        var number = NumberOf(point.Label);
        return number >= 0
            ? new(
                number, place is null ? null : Whole(place.Value.I, point.Line), place is null ? null : Whole(place.Value.J, point.Line),
                point.Position, isCenter, point.Line)
            : throw InputException.At(
                "bad-number",
                file.File,
                $"found the point {ProbingLogReader.Shown(point.Label)}; expected the number of a point of the plan, such as 12 or P12, or "
                    + $"its place i,j.",
                point.Line);
    }

    // A place in the plan: 3,4.
    private static (int I, int J)? PlaceOf(string label) =>
        label.Split(',') is [var first, var second]
        && int.TryParse(first, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var i)
        && int.TryParse(second, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var j)
            ? (i, j)
            : null;

    // The number in a point's name: 12, P12, point 12. -1 if there is none.
    private static int NumberOf(string label)
    {
        var digits = label.Length;
        while (digits > 0 && char.IsAsciiDigit(label[digits - 1]))
        {
            digits--;
        }

        return int.TryParse(label.AsSpan(digits), NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            && !label.AsSpan(0, digits).ContainsAny(OfNumbers)
            ? number
            : -1;
    }

    private int Whole(string text, int line) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var value)
            ? value
            : throw InputException.At(
                MeasurementError.TextForNumber,
                file.File,
                $"found {ProbingLogReader.Shown(text)} as a place in the plan; expected a whole number as in plan.csv.",
                line);
}
