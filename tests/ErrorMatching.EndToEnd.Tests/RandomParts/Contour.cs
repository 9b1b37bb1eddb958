namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A contour in the generator's own frame, material left of the travel, with what each of its features is and a place on the
/// tool's side before and behind it.</summary>
internal sealed record Contour(
    IReadOnlyList<ContourPiece> Pieces, IReadOnlyList<(string Kind, string Shape)> Features, Flat LeadIn, Flat LeadOut);
