using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A random program on one topic that LinuxCNC accepts. It states its units, modes and position first, and numbers each block by its line,
/// so that motions can be matched by their blocks. The same seed gives the same program.
/// </summary>
internal sealed partial class RandomProgram
{
    private readonly StringBuilder _text = new();
    private readonly Topic _topic;
    private ulong _state;
    private int _lines;

    // The place in the program's own units and active coordinates, and the modes that words depend on.
    private double[] _at = [0, 0, 0];
    private string _motion = "";
    private bool _incremental;
    private bool _absoluteCenters;
    private bool _inch;
    private bool _inverseTime;
    private string _feedMode = "G94";
    private CoordinatePlane _plane;

    private RandomProgram(Topic topic, int seed)
    {
        _topic = topic;
        _state = ((ulong)seed * 1000) + (ulong)topic;
    }

    /// <summary>Writes a program.</summary>
    public static string Write(Topic topic, int seed)
    {
        var program = new RandomProgram(topic, seed);
        program.WriteAll();
        return program._text.ToString();
    }

    private void WriteAll()
    {
        _inch = Chance(0.3);
        Block((_inch ? "G20" : "G21") + " G17 G90 G91.1 G94 G40 G49 G80 G98 G54 M3 S1000");
        if (_topic >= Topic.WorkOffsets)
        {
            StateOffsets();
        }

        Restate();
        var steps = 8 + Below(20);
        for (var i = 0; i < steps; i++)
        {
            if (_topic == Topic.Everything)
            {
                FeedPerMinute();
                var topic = (Topic)Below((int)Topic.Everything);
                Step(topic);
                if (topic == Topic.Expressions)
                {
                    Restate();
                }
            }
            else
            {
                Step(_topic);
            }
        }

        Line("M2");
    }

    private void Step(Topic topic)
    {
        switch (topic)
        {
            case Topic.Lines: WriteLine(); break;
            case Topic.ArcsByCenter: WriteArc(byRadius: false, full: false); break;
            case Topic.ArcsByRadius: WriteArc(byRadius: true, full: false); break;
            case Topic.Turns: WriteArc(byRadius: false, full: Chance(0.5)); break;
            case Topic.Planes: WritePlane(); break;
            case Topic.Units: WriteUnits(); break;
            case Topic.Spelling: WriteSpelling(); break;
            case Topic.Feeds: WriteFeedMode(); break;
            case Topic.WorkOffsets: WriteWorkOffset(rotated: false); break;
            case Topic.RotatedOffsets: WriteWorkOffset(rotated: true); break;
            case Topic.TouchedOffsets: WriteTouchedOffset(); break;
            case Topic.SetPositions: WriteSetPosition(); break;
            case Topic.LocalShifts: WriteLocalShift(); break;
            case Topic.MachineCoordinates: WriteMachineCoordinates(); break;
            case Topic.ToolLengths: WriteToolLength(); break;
            case Topic.References: WriteReference(); break;
            case Topic.Cycles: WriteCycles(); break;
            case Topic.CyclesInPlanes: WritePlaneCode(); WriteCycles(); break;
            case Topic.Expressions: WriteExpressions(); break;
            case Topic.Flow: WriteFlow(); break;
            case Topic.Subprograms: WriteSubprogram(); break;
            case Topic.Probes: WriteProbe(); break;
            case Topic.Splines: WriteSpline(); break;
            case Topic.Compensation: WriteCompensation(); break;
            case Topic.Polar: WriteInPlaneXY(WritePolar); break;
            case Topic.OddBlocks: WriteOddBlock(); break;
            case Topic.SavedModes: WriteSavedModes(); break;
        }
    }

    private void WriteInPlaneXY(Action write)
    {
        if (_plane != CoordinatePlane.XY)
        {
            _plane = CoordinatePlane.XY;
            Block("G17");
        }

        write();
    }

    // Any simple motion: what comes between the blocks of a topic.
    private void WriteMotion()
    {
        switch (Below(4))
        {
            case 0: WriteArc(byRadius: true, full: false); break;
            case 1: WriteArc(byRadius: false, full: Chance(0.3)); break;
            default: WriteLine(); break;
        }
    }

    // Where the position in the active coordinates is not followed here, all coordinates are said again.
    private void Restate()
    {
        _at = [Length(), Length(), Length()];
        _incremental = false;
        _motion = "G0";
        Block($"G90 G0 X{Number(_at[0])} Y{Number(_at[1])} Z{Number(_at[2])} F{Feed()}");
    }

    // What an offset is to begin with only the machine knows; a program that shifts by known amounts says it first.
    private void StateOffsets()
    {
        Block("G92.1");
        for (var system = 1; system <= Systems.Length; system++)
        {
            Block($"G10 L2 P{system} X0 Y0 Z0 R0");
        }
    }

    private void Block(string words) => Line($"N{_lines + 1} {words}");

    private void Line(string line)
    {
        _lines++;
        _text.Append(line).Append('\n');
    }

    private string Feed() => Number(_inch ? 1 + Below(50) : 50 + Below(2000));

    private double Grid(double value) => Math.Round(value, _inch ? 4 : 3) + 0.0;

    private double Length() => Grid(Uniform(-60, 60) / (_inch ? 25.4 : 1));

    private static string Number(double value) => (value + 0.0).ToString("0.#####", CultureInfo.InvariantCulture);

    private bool Chance(double part) => Uniform(0, 1) < part;

    private int Below(int count) => (int)(Uniform(0, 1) * count);

    private T Any<T>(params ReadOnlySpan<T> choices) => choices[Below(choices.Length)];

    // SplitMix64: the same numbers everywhere.
    private double Uniform(double low, double high)
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return low + ((high - low) * Math.ScaleB((mixed ^ (mixed >> 31)) >> 11, -53));
    }
}
