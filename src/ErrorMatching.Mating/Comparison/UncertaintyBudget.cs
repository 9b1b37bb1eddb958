namespace ErrorMatching.Mating;

/// <summary>The standard uncertainty of a measured coordinate and what it is made of (Wang 2021, section 2.2).</summary>
/// <param name="Contributions">Its causes, taken as independent.</param>
public sealed record UncertaintyBudget(IReadOnlyList<UncertaintyContribution> Contributions)
{
    /// <summary>All contributions by root sum of squares.</summary>
    public double CombinedMm => Math.Sqrt(Contributions.Sum(c => c.ValueMm * c.ValueMm));

    /// <summary>A budget of a single number.</summary>
    public static UncertaintyBudget Of(double valueMm) => new([new("gauge", valueMm)]);
}
