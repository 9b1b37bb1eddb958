namespace ErrorMatching.Measurement;

/// <summary>The rules by which a shop tells the measurement of a part from that of its counterpart. A file is a side's if any rule of that side matches and none of the other.</summary>
/// <param name="part">Rules that say it is the part's.</param>
/// <param name="counterpart">Rules that say it is the counterpart's.</param>
public sealed class SourceRules(IReadOnlyList<SourceRule> part, IReadOnlyList<SourceRule> counterpart)
{
    /// <summary>Whose measurement a file is.</summary>
    /// <exception cref="MeasurementException">No rule matches (<see cref="MeasurementError.UndecidedSource"/>), or rules of both sides do
    /// (<see cref="MeasurementError.ContradictorySource"/>): the message says which.</exception>
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

    private static List<SourceRule> Matching(IReadOnlyList<SourceRule> rules, MeasurementFile file) => [.. rules.Where(r => r.Matches(file))];

    private static string Words(IReadOnlyList<SourceRule> rules) => rules.Count == 0 ? "no rule" : string.Join(", ", rules);
}
