namespace ErrorMatching.Mating;

/// <summary>The standard uncertainty of a measured coordinate and its contributions (Wang 2021, section 2.2).</summary>
/// <param name="Contributions">Its causes, assumed independent.</param>
public sealed record UncertaintyBudget(IReadOnlyList<UncertaintyContribution> Contributions)
{
    /// <summary>Coverage factor k of the expanded uncertainty: 2, about 95 % of normally distributed errors.</summary>
    internal const double CoverageFactor = 2;

    /// <summary>Smallest standard uncertainty that is calculated with, mm: a hundredth of what a word of a program can say.</summary>
    internal const double LeastMm = 0.00001;

    /// <summary>Root sum of squares of all contributions.</summary>
    public double CombinedMm => Math.Sqrt(Contributions.Sum(c => c.ValueMm * c.ValueMm));

    /// <summary>Root sum of squares of the contributions that all points share.</summary>
    public double SharedMm => Math.Sqrt(Contributions.Where(c => c.IsShared).Sum(c => c.ValueMm * c.ValueMm));

    /// <summary>A budget with a single contribution.</summary>
    public static UncertaintyBudget Of(double valueMm) => new([new("gauge", valueMm)]);
}

/// <summary>One cause of uncertainty of a measured coordinate.</summary>
/// <param name="Name">The cause.</param>
/// <param name="ValueMm">Its standard uncertainty, zero or more.</param>
public sealed record UncertaintyContribution(string Name, double ValueMm)
{
    /// <summary>True if it moves all points of a measurement alike along their normals, as temperature or the radius of the stylus
    /// does.</summary>
    public bool IsShared { get; init; }
}
