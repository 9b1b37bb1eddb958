namespace ErrorMatching.Mating;

/// <summary>The angle inside the corner between two consecutive straight elements.</summary>
/// <param name="Name">Its name.</param>
/// <param name="First">The element that is cut first.</param>
/// <param name="Second">The element that is cut next.</param>
public sealed record AngleComparison(string Name, ElementReference First, ElementReference Second) : JobComparison(Name);
