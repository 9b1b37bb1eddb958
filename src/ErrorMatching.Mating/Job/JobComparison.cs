using System.Globalization;

namespace ErrorMatching.Mating;

/// <summary>A comparison of counterpart and part in addition to those that every feature has.</summary>
/// <param name="Name">Its name, unique among comparisons and features.</param>
public abstract record JobComparison(string Name);

/// <summary>The angle inside the corner between two consecutive straight elements.</summary>
/// <param name="Name">Its name.</param>
/// <param name="First">The element that is cut first.</param>
/// <param name="Second">The element that is cut next.</param>
internal sealed record AngleComparison(string Name, ElementReference First, ElementReference Second) : JobComparison(Name);

/// <summary>The largest deviation of some key points.</summary>
/// <param name="Name">Its name.</param>
/// <param name="AlongX">True for deviations along the first axis, as in the paper; false for deviations along the normals.</param>
/// <param name="Points">Labels of at least one key point.</param>
internal sealed record DeviationComparison(string Name, bool AlongX, IReadOnlyList<string> Points) : JobComparison(Name);

/// <summary>A straight element of the boundary: a line feature, or a flank of a triangle.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Flank">1 or 2 for a flank in the order of cutting; null for a line.</param>
internal readonly record struct ElementReference(string Feature, int? Flank)
{
    /// <summary>As the job writes it: <c>L1</c> or <c>L2L3/1</c>.</summary>
    public override string ToString() => Flank is null ? Feature : string.Create(CultureInfo.InvariantCulture, $"{Feature}/{Flank}");
}
