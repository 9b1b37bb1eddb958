namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A place on the outline of the dovetail.</summary>
/// <param name="Element">The element that it is on.</param>
/// <param name="Place">Where it is as designed.</param>
/// <param name="Normal">Unit vector from the key's material to the tool.</param>
/// <param name="TrueMm">How far the part's boundary really is from there along the normal.</param>
internal sealed record DovetailPoint(string Element, Flat Place, Flat Normal, double TrueMm);
