using System.Globalization;

namespace ErrorMatching.Peers.Tests;

/// <summary>Everything that shifts coordinates.</summary>
internal sealed class OffsetPart(ProgramDraft draft, RandomNumbers random, MotionPart motions)
    : ProgramPart(draft, random)
{
    private static readonly string[] Systems = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

    private readonly HashSet<string> _stored = [];

    /// <summary>What an offset is to begin with only the machine knows; a program that shifts by known amounts says it first.</summary>
    public void StateOffsets()
    {
        Block("G92.1");
        for (var system = 1; system <= Systems.Length; system++)
        {
            Block($"G10 L2 P{system} X0 Y0 Z0 R0");
        }
    }

    public void WriteWorkOffset(bool rotated)
    {
        switch (Below(3))
        {
            case 0:
                var system = 1 + Below(9);
                Block(
                    $"G10 L2 P{system} X{Number(Length())} Y{Number(Length())} "
                        + $"Z{Number(Length())}{(rotated ? " R" + Number(Any(0, 10.0, 30.0, -45.0, 90.0, 17.5)) : "")}");
                Block(Systems[system - 1]);
                Shifted();
                break;
            case 1:
                var other = 1 + Below(9);
                Block($"G10 L2 P{other} X{Number(Length())} Y{Number(Length())} Z{Number(Length())}");
                Block(Systems[other - 1]);
                Shifted();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteTouchedOffset()
    {
        if (Chance(0.5))
        {
            var system = 1 + Below(9);
            Block($"G10 L20 P{system} X{Number(Length())} Y{Number(Length())} Z{Number(Length())}");
            Block(Systems[system - 1]);
            Shifted();
        }

        motions.WriteMotion();
    }

    public void WriteSetPosition()
    {
        switch (Below(6))
        {
            case 0:
            case 1:
                Block("G92" + SomeAxes());
                Shifted();
                break;
            case 2:
                Block(Any("G92.1", "G92.2"));
                Shifted();
                break;
            case 3:
                Block("G92.3");
                Shifted();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteLocalShift()
    {
        if (Chance(0.4))
        {
            Block("G52" + SomeAxes());
            Shifted();
        }

        motions.WriteMotion();
    }

    public void WriteMachineCoordinates()
    {
        switch (Below(4))
        {
            case 0:
                Block($"G90 G53 {Any("G0", "G1")}" + SomeAxes());
                Draft.IsIncremental = false;
                Draft.Motion = "";
                Shifted();
                break;
            case 1:
                WriteSetPosition();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteToolLength()
    {
        switch (Below(4))
        {
            case 0:
                Block(Chance(0.7) ? $"G43.1 Z{Number(Length())}" : $"G43.1 X{Number(Length())} Z{Number(Length())}");
                Shifted();
                break;
            case 1:
                Block("G49");
                Shifted();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteReference()
    {
        switch (Below(4))
        {
            case 0:
                // A place that the program has not stored itself only the machine knows; parameters would give one in the machine's unit.
                var home = Any("G28", "G30");
                if (_stored.Add(home) || Chance(0.4))
                {
                    Block(home + ".1");
                    motions.WriteMotion();
                }

                Block(home + (Chance(0.5) ? SomeAxes() : ""));
                Shifted();
                break;
            default:
                motions.WriteMotion();
                break;
        }
    }

    public void WriteCompensation()
    {
        if (Chance(0.3))
        {
            Block(Any("G40", "G41 D1", "G42 D2", "G41.1 D" + Number(0.5), "G42.1 D" + Number(0.5)));
        }

        motions.WriteMotion();
    }

    // Increments go on from the shifted place, whatever it is; anything else needs its coordinates stated.
    private void Shifted()
    {
        if (Chance(0.4))
        {
            for (var i = 1 + Below(2); i > 0; i--)
            {
                Block(string.Create(CultureInfo.InvariantCulture, $"G91 {Any("G0", "G1")}{SomeAxes()}"));
            }

            if (Chance(0.5))
            {
                Block($"G90 {Any("G0", "G1")} {Any("X", "Y", "Z")}{Number(Length())}");
            }
        }

        Restate();
    }

    private string SomeAxes()
    {
        var words = "";
        for (var axis = 0; axis < 3; axis++)
        {
            if (Chance(0.5) || (axis == 2 && words.Length == 0))
            {
                words += $" {"XYZ"[axis]}{Number(Length())}";
            }
        }

        return words;
    }
}
