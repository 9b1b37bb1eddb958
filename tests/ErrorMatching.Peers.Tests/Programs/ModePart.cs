namespace ErrorMatching.Peers.Tests;

/// <summary>Modes that are saved and restored.</summary>
internal sealed class ModePart(ProgramDraft draft, RandomNumbers random)
    : ProgramPart(draft, random)
{
    private int _feeds;

    // Two subprograms that change modes, one of which calls the other; around the calls the main program saves and restores all it needs.
    public void WriteSavedModes()
    {
        var (inner, outer) = (Draft.NextLabel(), Draft.NextLabel());
        Line($"o{inner} sub");
        WriteLevel(inner, null);
        Line($"o{inner} endsub");
        Line($"o{outer} sub");
        WriteLevel(outer, inner);
        Line($"o{outer} endsub");
        Line("M70");
        for (var i = 1 + Below(3); i > 0; i--)
        {
            if (Chance(0.4))
            {
                WriteModes();
            }

            Line($"o{Any(inner, outer)} call{Any("", " (modes)", " [1] (modes) [2]")}");
            WriteSomewhere();
        }

        Line("M72");
        WriteSomewhere();
        Restate();
    }

    private void WriteLevel(int label, int? called)
    {
        var saves = Any("M70", "M73", "M73", "");
        if (saves.Length > 0)
        {
            Block(Any("G20", "G21"));
            Block($"F{NextFeed()}");
            Block(saves + Any("", "", " G91", " G90"));
        }

        WriteModes();
        WriteSomewhere();
        if (called is { } other)
        {
            Line($"o{other} call");
            WriteSomewhere();
        }

        if (saves.Length > 0 && Chance(0.5))
        {
            Block(Any("M70", "M71", "M72", "M72", "M72"));
            WriteModes();
            WriteSomewhere();
        }

        if (Chance(0.2))
        {
            Line($"o{label} return");
        }
    }

    // A feed behind each change of units, and without decimals: the peer compares feeds by their numbers and restores one decimal.
    private void WriteModes()
    {
        for (var i = 1 + Below(4); i > 0; i--)
        {
            Block(Any("G90", "G91", "G17", "G18", "G19", "G90.1", "G91.1", "G98", "G99", "G54", "G55", "G59.1", "G61"));
        }

        if (Chance(0.5))
        {
            Block(Any("G20", "G21"));
            Block($"F{NextFeed()}");
        }
    }

    private string NextFeed() => Number(3000 + ++_feeds);

    private void WriteSomewhere() => Block(Any(
        $"G1 X{Number(Length())} Y{Number(Length())}",
        $"G0 Z{Number(Length())}",
        $"G1 X{Number(Length())} Z{Number(Length())}",
        $"G17 G2 I{Number(1 + Below(5))} J{Number(70 + Below(5))}"));
}
