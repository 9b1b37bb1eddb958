using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The shop's rules that distinguish measurements of a part and its counterpart. A file belongs to a side if any rule of that
/// side matches and none of the other.</summary>
/// <param name="part">Rules that identify the part.</param>
/// <param name="counterpart">Rules that identify the counterpart.</param>
public sealed class SourceRules(IReadOnlyList<SourceRule> part, IReadOnlyList<SourceRule> counterpart)
{
    /// <summary>Determines the source of a measurement.</summary>
    /// <exception cref="InputException">No rule matches (<see cref="MeasurementError.UndecidedSource"/>), or rules of both sides do
    /// (<see cref="MeasurementError.ContradictorySource"/>). The message names the rules.</exception>
    public SourceSide Decide(MeasurementFile file)
    {
        var (forPart, forCounterpart) = (Matching(part, file), Matching(counterpart, file));
        return (forPart.Count, forCounterpart.Count) switch
        {
            ( > 0, 0) => SourceSide.Part,
            (0, > 0) => SourceSide.Counterpart,
            (0, 0) => throw Place.Start(file.File).Fail(
                MeasurementError.UndecidedSource,
                "a file that no rule matches",
                $"one that is the part's ({Words(part)}) or the counterpart's ({Words(counterpart)})"),
            _ => throw Place.Start(file.File).Fail(
                MeasurementError.ContradictorySource,
                $"a file that is the part's, because {Words(forPart)}, and the counterpart's, because {Words(forCounterpart)}",
                "rules of one side only: make the patterns narrower"),
        };
    }

    private static List<SourceRule> Matching(IReadOnlyList<SourceRule> rules, MeasurementFile file) =>
        [.. rules.Where(r => r.Matches(file))];

    private static string Words(IReadOnlyList<SourceRule> rules) => rules.Count == 0 ? "no rule" : string.Join(", ", rules);
}

/// <summary>The source of a measurement.</summary>
public enum SourceSide
{
    /// <summary>The part, which was cut first and is to be matched.</summary>
    Part,

    /// <summary>The counterpart, whose program is rewritten.</summary>
    Counterpart,
}
