namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A random program on one topic that LinuxCNC accepts. It states its units, modes and position first, and numbers each block by its line,
/// so that motions can be matched by their blocks. The same seed gives the same program.
/// </summary>
internal sealed class RandomProgram
{
    private readonly Topic _topic;
    private readonly ProgramDraft _draft = new();
    private readonly RandomNumbers _random;
    private readonly MotionPart _motions;
    private readonly SpellingPart _spelling;
    private readonly OffsetPart _offsets;
    private readonly CyclePart _cycles;
    private readonly FlowPart _flow;
    private readonly ModePart _modes;

    private RandomProgram(Topic topic, int seed)
    {
        _topic = topic;
        _random = new(((ulong)seed * 1000) + (ulong)topic);
        _motions = new(_draft, _random, topic is Topic.Turns or Topic.Everything);
        _spelling = new(_draft, _random, _motions);
        _offsets = new(_draft, _random, _motions);
        _cycles = new(_draft, _random, _motions);
        _flow = new(_draft, _random);
        _modes = new(_draft, _random);
    }

    /// <summary>Writes a program.</summary>
    public static string Write(Topic topic, int seed)
    {
        var program = new RandomProgram(topic, seed);
        program.WriteAll();
        return program._draft.Text.ToString();
    }

    private void WriteAll()
    {
        _draft.IsInch = _random.Chance(0.3);
        _draft.Block((_draft.IsInch ? "G20" : "G21") + " G17 G90 G91.1 G94 G40 G49 G80 G98 G54 M3 S1000");
        if (_topic >= Topic.WorkOffsets)
        {
            _offsets.StateOffsets();
        }

        _motions.Restate();
        var steps = 8 + _random.Below(20);
        for (var i = 0; i < steps; i++)
        {
            if (_topic == Topic.Everything)
            {
                _cycles.FeedPerMinute();
                var topic = (Topic)_random.Below((int)Topic.Everything);
                Step(topic);
                if (topic == Topic.Expressions)
                {
                    _motions.Restate();
                }
            }
            else
            {
                Step(_topic);
            }
        }

        _draft.Line("M2");
    }

    private void Step(Topic topic)
    {
        switch (topic)
        {
            case Topic.Lines: _motions.WriteLine(); break;
            case Topic.ArcsByCenter: _motions.WriteArc(byRadius: false, full: false); break;
            case Topic.ArcsByRadius: _motions.WriteArc(byRadius: true, full: false); break;
            case Topic.Turns: _motions.WriteArc(byRadius: false, full: _random.Chance(0.5)); break;
            case Topic.Planes: _motions.WritePlane(); break;
            case Topic.Units: _motions.WriteUnits(); break;
            case Topic.Spelling: _spelling.WriteSpelling(); break;
            case Topic.Feeds: _cycles.WriteFeedMode(); break;
            case Topic.WorkOffsets: _offsets.WriteWorkOffset(rotated: false); break;
            case Topic.RotatedOffsets: _offsets.WriteWorkOffset(rotated: true); break;
            case Topic.TouchedOffsets: _offsets.WriteTouchedOffset(); break;
            case Topic.SetPositions: _offsets.WriteSetPosition(); break;
            case Topic.LocalShifts: _offsets.WriteLocalShift(); break;
            case Topic.MachineCoordinates: _offsets.WriteMachineCoordinates(); break;
            case Topic.ToolLengths: _offsets.WriteToolLength(); break;
            case Topic.References: _offsets.WriteReference(); break;
            case Topic.Cycles: _cycles.WriteCycles(); break;
            case Topic.CyclesInPlanes: _motions.WritePlaneCode(); _cycles.WriteCycles(); break;
            case Topic.Expressions: _flow.WriteExpressions(); break;
            case Topic.Flow: _flow.WriteFlow(); break;
            case Topic.Subprograms: _flow.WriteSubprogram(); break;
            case Topic.Probes: _cycles.WriteProbe(); break;
            case Topic.Splines: _cycles.WriteSpline(); break;
            case Topic.Compensation: _offsets.WriteCompensation(); break;
            case Topic.Polar: _cycles.WritePolar(); break;
            case Topic.OddBlocks: _cycles.WriteOddBlock(); break;
            case Topic.SavedModes: _modes.WriteSavedModes(); break;
        }
    }
}
