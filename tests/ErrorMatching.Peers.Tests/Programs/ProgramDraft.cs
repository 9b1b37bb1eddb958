using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>A program while it is written: its text, and the place and the modes that the words of its next block depend on. Blocks are
/// numbered by their lines.</summary>
internal sealed class ProgramDraft
{
    private int _labels = 100;

    public StringBuilder Text { get; } = new();

    /// <summary>Number of lines.</summary>
    public int Lines { get; private set; }

    /// <summary>The place in the program's own units and active coordinates.</summary>
    public double[] At { get; set; } = [0, 0, 0];

    /// <summary>The motion code in force; empty if none is.</summary>
    public string Motion { get; set; } = "";

    public bool IsIncremental { get; set; }

    public bool HasAbsoluteCenters { get; set; }

    public bool IsInch { get; set; }

    public string FeedMode { get; set; } = "G94";

    public CoordinatePlane Plane { get; set; }

    public void Block(string words) => Line($"N{Lines + 1} {words}");

    public void Line(string line)
    {
        Lines++;
        Text.Append(line).Append('\n');
    }

    /// <summary>A label that no flow and no subprogram has yet.</summary>
    public int NextLabel() => _labels++;
}
