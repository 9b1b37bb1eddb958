using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>How many blocks of a program a dialect does not know, each looked at by itself, so that the cost has a bound: the first
/// blocks of the program, and no loop runs.</summary>
public sealed class DialectFit
{
    /// <summary>Code of the refusal of a program in another dialect.</summary>
    public const string WrongDialect = "wrong-dialect";

    private const int MostBlocks = 300;

    private DialectFit(NcDialect dialect, int unknown, int blocks, NcDialect? better, int unknownToBetter) =>
        (Dialect, Unknown, Blocks, Better, UnknownToBetter) = (dialect, unknown, blocks, better, unknownToBetter);

    /// <summary>The dialect in which the program was read.</summary>
    public NcDialect Dialect { get; }

    /// <summary>Number of blocks that have words unknown to it.</summary>
    public int Unknown { get; }

    /// <summary>Number of blocks that were looked at.</summary>
    public int Blocks { get; }

    /// <summary>The built-in dialect to which less than half as many blocks are unknown, and at most a tenth of all; null if there is
    /// none.</summary>
    public NcDialect? Better { get; }

    /// <summary>Number of blocks that have words unknown to that one.</summary>
    public int UnknownToBetter { get; }

    /// <summary>What to do, in a sentence or two.</summary>
    public string Sentence => string.Create(
        CultureInfo.InvariantCulture,
        $"{Unknown} of {(Blocks == MostBlocks ? "the first " : "")}{Blocks} blocks have words "
            + $"that the dialect {Dialect.Name} does not know. ")
        + (Better is null ? "No built-in dialect knows many more: is this an NC program?"
            : UnknownToBetter == 0 ? $"The dialect {Better.Name} knows all of them: is the program for that control?"
            : string.Create(CultureInfo.InvariantCulture,
                $"To the dialect {Better.Name}, {UnknownToBetter} are unknown: is the program for that control?"));

    /// <summary>Compares dialects for a program; null if the given one knows the words of at least half of the blocks.</summary>
    /// <param name="program">The program.</param>
    /// <param name="dialect">The dialect in which it was read.</param>
    public static DialectFit? Of(NcProgram program, NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(dialect);
        var blocks = Sample(program);
        var unknown = UnknownTo(dialect, blocks, blocks.Count);
        if (2 * unknown <= blocks.Count)
        {
            return null;
        }

        // Text that is no program has few words that are unknown to one dialect or the other by chance.
        var (better, least) = ((NcDialect?)null, Math.Min(((unknown + 1) / 2) - 1, blocks.Count / 10));
        foreach (var other in NcDialects.All.Where(d => d.Name != dialect.Name))
        {
            if (UnknownTo(other, blocks, least) is var count && (count < least || (count == least && better is null)))
            {
                (better, least) = (other, count);
            }
        }

        return new(dialect, unknown, blocks.Count, better, least);
    }

    /// <summary>The refusal of a program most of whose blocks are not known; null if they are.</summary>
    /// <param name="program">The program.</param>
    /// <param name="dialect">The dialect in which it was read.</param>
    public static Refusal? Refusal(NcProgram program, NcDialect dialect) =>
        Of(program, dialect) is { } fit ? new(WrongDialect, fit.Sentence) : null;

    private static List<byte[]> Sample(NcProgram program)
    {
        var blocks = new List<byte[]>();
        for (var i = 0; i < program.BlockCount && blocks.Count < MostBlocks; i++)
        {
            // The percent sign of a tape, and comments, say nothing of the dialect.
            var text = program.BytesOf(program[i]).Trim(" \t\r"u8);
            if (text.Length > 0 && text.Length < 1000 && text[0] is not ((byte)'%' or (byte)'(' or (byte)';'))
            {
                blocks.Add(text.ToArray());
            }
        }

        return blocks;
    }

    // Stops behind the limit: then others know more.
    private static int UnknownTo(NcDialect dialect, List<byte[]> blocks, int most)
    {
        var count = 0;
        foreach (var block in blocks)
        {
            var path = NcInterpreter.Run(NcProgram.Read(block, dialect.Syntax), dialect);
            count += path.Problems.Any(p => p.Code is NcRefusalCodes.UnknownWord or "unknown-code") ? 1 : 0;
            if (count > most)
            {
                break;
            }
        }

        return count;
    }
}
