namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Cutter compensation of a move: none (G40), tool left of the travel (G41) or right of it (G42).</summary>
internal enum CutterSide
{
    None,
    Left,
    Right,
}
