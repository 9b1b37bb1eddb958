using System.Globalization;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>How far a program is understood: the blocks that are not, those that block skip passes over, and the motions whose end only
/// the machine knows.</summary>
internal sealed class Understanding
{
    /// <summary>Code of the refusal of a program that is not understood as a whole.</summary>
    public const string NotUnderstood = "not-understood";

    private readonly NcPath _path;

    public Understanding(NcPath path)
    {
        _path = path;
        var blocks = new SortedSet<int>(path.Problems.Select(p => p.Block));
        blocks.UnionWith(path.Notes.Where(n => n.Code is "opaque-transform" or "cycle-not-followed").Select(n => n.Block));
        blocks.UnionWith(path.UnfollowedWays);
        foreach (var motion in path.Motions)
        {
            if (motion.Kind == MotionKind.Cycle)
            {
                blocks.Add(motion.Block);
            }

            OfMachine += motion.UnknownEnd != AxisSet.None ? 1 : 0;
        }

        Blocks = [.. blocks];
        Refused = [.. path.Problems.Where(p => p.Code == NcRefusalCodes.RefusedByControl).Select(p => p.Block).Distinct().Order()];
        Skipped = path.Dialect.BlockSkip == BlockSkip.On ? path.Notes.Where(n => n.Code == "block-skip").Sum(n => n.Count) : 0;
    }

    /// <summary>Blocks with something that is not understood or not followed, in order.</summary>
    public IReadOnlyList<int> Blocks { get; }

    /// <summary>Those of them that the control refuses, in order.</summary>
    public int[] Refused { get; }

    /// <summary>How often block skip passed over a block.</summary>
    public long Skipped { get; }

    /// <summary>Number of motions that end where at least one coordinate is not said by the program.</summary>
    public int OfMachine { get; }

    /// <summary>What the program is, in one or a few sentences.</summary>
    public string Sentence
    {
        get
        {
            var refused = Refused.Length == 0 ? ""
                : Invariant($"The control refuses {Refused.Length} of {_path.Program.BlockCount} blocks and stops at the first of them.");
            var others = Blocks.Count - Refused.Length;
            var uncertain = _path.UncertainBlocks;
            var text = _path.Refusal is not null ? "The program is followed up to the block that is refused, and not behind it."
                : Blocks.Count == 0 && uncertain.Count > 0
                    ? Invariant($"Every block is understood. How {uncertain.Count} of {_path.Program.BlockCount} move, the first being ")
                    + Invariant($"{_path.Program.NameOf(_path.Program[uncertain.Min()])}, depends on block skip or on a value of the ")
                    + "machine: both ways meet again, and one is shown. State the other with --block-skip or --assume."
                : Blocks.Count == 0 ? "Everything is understood."
                : others == 0 ? refused
                : Invariant($"{others} of {_path.Program.BlockCount} blocks {(others == 1 ? "is" : "are")} not understood.")
                    + (refused.Length > 0 ? " " + refused : "");
            text += Skipped > 0 ? Invariant($" Block skip passes over {Skipped}.") : "";
            return OfMachine == 0
                ? text
                : text + Invariant($" Where {OfMachine} of {_path.Motions.Length} motions end, only the machine knows.");
        }
    }

    /// <summary>The reason why a program that must be understood as a whole is refused; null if it is understood.</summary>
    public Refusal? Refusal => Blocks.Count == 0 ? null
        : Refused.Length > 0 ? BlockRefusal.At(
            _path.Program,
            Refused[0],
            NcRefusalCodes.RefusedByControl,
            _path.Problems.First(p => p.Block == Refused[0] && p.Code == NcRefusalCodes.RefusedByControl).Message)
        : BlockRefusal.At(
        _path.Program,
        Blocks[0],
        NotUnderstood,
        Invariant($"this block is the first of {Blocks.Count} that are not understood or not followed. Choose the control's dialect, or ")
            + "state in a dialect file what its words mean.");

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
