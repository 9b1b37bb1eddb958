namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How the tool goes: along an open run, around a boss (outside cut), inside a pocket (inside cut).</summary>
internal enum ContourKind
{
    Open,
    Boss,
    Pocket,
}
