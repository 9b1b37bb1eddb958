using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A rule by which a gauge names the points of a job: <c>PNT{n}</c> says that the job's point 5 is PNT5 in the gauge's
/// files.</summary>
/// <remarks><c>{n}</c> is the number at the end of the job's label, without leading zeros: 5 of <c>5</c>, <c>P5</c> and <c>P05</c>.
/// <c>{label}</c> is the whole label.</remarks>
public sealed class LabelRule
{
    private const string Number = "{n}", Whole = "{label}";
    private const int LongestRule = 100, LongestLabel = 1000;

    private readonly string _before;
    private readonly string _behind;
    private readonly bool _isWhole;

    private LabelRule(string before, bool isWhole, string behind) => (_before, _isWhole, _behind) = (before, isWhole, behind);

    /// <summary>Reads a rule.</summary>
    /// <param name="text">Text with <c>{n}</c> or <c>{label}</c> once, of at most 100 characters.</param>
    /// <exception cref="InputException">It is no such text (<see cref="MeasurementError.BadLabels"/>).</exception>
    public static LabelRule Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        foreach (var (holder, isWhole) in new[] { (Number, false), (Whole, true) })
        {
            var at = text.IndexOf(holder, StringComparison.Ordinal);
            if (at >= 0 && text.Length <= LongestRule)
            {
                var (before, behind) = (text[..at], text[(at + holder.Length)..]);
                if (!before.AsSpan().ContainsAny('{', '}') && !behind.AsSpan().ContainsAny('{', '}'))
                {
                    return new(before.TrimStart(), isWhole, behind.TrimEnd());
                }
            }
        }

        throw MeasurementRefusal.Of(
            MeasurementError.BadLabels,
            $"the rule {MeasurementRefusal.Quote(text)}",
            $"a label with {Number}, the number of the job's label, or {Whole}, the whole label, once, such as PNT{Number}");
    }

    /// <summary>The name of a job's point in the gauge's files.</summary>
    /// <param name="label">The job's label.</param>
    /// <exception cref="InputException">The label has no number at its end, which the rule needs
    /// (<see cref="MeasurementError.BadLabels"/>).</exception>
    public string Apply(string label) => _before + (_isWhole ? label : NumberOf(label) ?? throw MeasurementRefusal.Of(
        MeasurementError.BadLabels,
        $"the point {MeasurementRefusal.Quote(label)} under the rule {MeasurementRefusal.Quote(ToString())}",
        $"a number at the end of each label of the job; use {Whole} for the whole label")) + _behind;

    /// <summary>The rule as text.</summary>
    public override string ToString() => _before + (_isWhole ? Whole : Number) + _behind;

    /// <summary>The job's labels by their names in the gauge's files.</summary>
    /// <exception cref="InputException">Two labels have the same name, or one has no number.</exception>
    internal IReadOnlyDictionary<string, string> Invert(IEnumerable<string> labels)
    {
        var names = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var label in labels)
        {
            var name = Apply(label);
            if (!names.TryAdd(name, label) && names[name] != label)
            {
                throw MeasurementRefusal.Of(
                    MeasurementError.BadLabels,
                    $"{MeasurementRefusal.Quote(name)} for the points {MeasurementRefusal.Quote(names[name])} and "
                        + MeasurementRefusal.Quote(label),
                    $"one point for each name: use {Whole} for the whole label in the rule {MeasurementRefusal.Quote(ToString())}");
            }
        }

        return names;
    }

    /// <summary>The rule by which one of a file's points has the number of a job's label; null if none or several have it.</summary>
    internal static LabelRule? Between(string label, IReadOnlyList<LabelledPoint> points)
    {
        if (NumberOf(label) is not { } number)
        {
            return null;
        }

        var same = points.Where(p => NumberOf(p.Label) == number).Take(2).ToArray();
        return same is [{ Label: var other }] && other.EndsWith(number, StringComparison.Ordinal)
            && other[..^number.Length] is var before && before.Length < LongestRule / 2 && !before.AsSpan().ContainsAny('{', '}')
                ? new(before, false, "")
                : null;
    }

    /// <summary>The number at the end of a label without leading zeros; null if there is none.</summary>
    internal static string? NumberOf(string label)
    {
        var start = label.Length;
        while (start > 0 && char.IsAsciiDigit(label[start - 1]))
        {
            start--;
        }

        return start == label.Length || label.Length > LongestLabel ? null
            : label.AsSpan(start).TrimStart('0') is { Length: > 0 } digits ? digits.ToString()
            : "0";
    }
}
