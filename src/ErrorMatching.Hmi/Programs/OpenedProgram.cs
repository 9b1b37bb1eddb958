using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>An opened program: its text, read line by line when shown, and its path. Immutable.</summary>
/// <remarks>Opening interprets the program; do it off the UI thread. It needs the program's bytes and about 60 bytes per block.</remarks>
public sealed class OpenedProgram
{
    /// <summary>Maximum number of characters shown of a line; a line can be as long as a file.</summary>
    public const int MostShown = 400;

    private OpenedProgram(NcPath path)
    {
        Path = path;
        Moves = new(path);
        LongestLine = Enumerable.Range(0, Count).Select(b => Math.Min(MostShown + 1, Path.Program[b].Length)).DefaultIfEmpty().Max();
    }

    /// <summary>The interpreted path.</summary>
    public NcPath Path { get; }

    /// <summary>The path as drawn.</summary>
    public MovePicture Moves { get; }

    public int Count => Path.Program.BlockCount;

    /// <summary>Upper limit of the characters shown of the longest line: a byte is at most one character.</summary>
    public int LongestLine { get; }

    /// <summary>Why the program could not be interpreted to its end, or what in it is not understood; null if nothing.</summary>
    public string? Problem => Path.Refusal is { } refusal
        ? CodeText.Of(refusal.Code, refusal.Message)
        : Path.Problems.Count > 0
            ? Texts.Current.With("Program.Problems", Shown.Count(Path.Problems.Count), Shown.Id(Path.Problems[0].Block + 1))
            : null;

    /// <summary>Opens a program.</summary>
    /// <param name="bytes">Its bytes. They are not copied: do not change them afterwards.</param>
    /// <param name="dialect">Its dialect.</param>
    /// <param name="cancellation">Cancels the opening.</param>
    /// <exception cref="InputException">The program is too large.</exception>
    /// <exception cref="OperationCanceledException">The opening was canceled.</exception>
    public static OpenedProgram Read(ReadOnlyMemory<byte> bytes, NcDialect dialect, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return new(NcInterpreter.Run(NcProgram.Read(bytes, dialect.Syntax), dialect, null, cancellation));
    }

    /// <summary>The text of a block, at most <see cref="MostShown"/> characters of it.</summary>
    public string LineAt(int block)
    {
        var (program, place) = (Path.Program, Path.Program[block]);
        if (place.Length <= MostShown)
        {
            return program.TextOf(place);
        }

        // Not in the middle of a character: continuation bytes begin with the bits 10.
        var length = MostShown;
        while (length > MostShown - 4 && (program.BytesOf(place)[length] & 0xC0) == 0x80)
        {
            length--;
        }

        return program.TextOf(place with { Length = length }) + "…";
    }

    /// <summary>The block number as written in the program, or the line number if there is none.</summary>
    public string NameOf(int block) =>
        Path.Program.NumberOf(Path.Program[block]) is { Length: > 0 } number
            ? number
            : Texts.Current.With("Program.Line", Shown.Id(block + 1));

    /// <summary>The first and last motion of a range of blocks, in the order of execution; null if there are none.</summary>
    public (int First, int Last)? MotionsOf(BlockRange range)
    {
        for (var block = range.First; block <= range.Last; block++)
        {
            if (Path.MotionOf(block) is var first and >= 0)
            {
                for (var end = range.Last; end >= block; end--)
                {
                    if (Path.MotionsOf(end) is [.., var last])
                    {
                        return (Math.Min(first, last), Math.Max(first, last));
                    }
                }
            }
        }

        return null;
    }

    /// <summary>True if a range contains a motion.</summary>
    public bool IsMoving(BlockRange range)
    {
        var block = range.First;
        while (block <= range.Last && Path.MotionOf(block) < 0)
        {
            block++;
        }

        return block <= range.Last;
    }

    /// <summary>A range without blocks at its ends that move nothing, such as comments; unchanged if nothing in it moves.</summary>
    public BlockRange Trimmed(BlockRange range)
    {
        var (first, last) = (range.First, range.Last);
        while (first < last && Path.MotionOf(first) < 0)
        {
            first++;
        }

        while (last > first && Path.MotionOf(last) < 0)
        {
            last--;
        }

        return Path.MotionOf(first) < 0 ? range : new(first, last);
    }

    /// <summary>Describes a motion: its block number, its end position, and its feed if it cuts.</summary>
    public string TellMotion(int motion)
    {
        var m = Path.Motions[motion];
        var feed = m.IsCut && m.Feed > 0
            ? Texts.Current.With("Program.Feed", m.Feed.ToString("0.###", System.Globalization.CultureInfo.InvariantCulture))
            : "";
        return $"{NameOf(m.Block)}\nX {Coordinate(m.End.X, AxisSet.X)}  Y {Coordinate(m.End.Y, AxisSet.Y)}  Z "
            + $"{Coordinate(m.End.Z, AxisSet.Z)} mm{feed}";

        string Coordinate(double value, AxisSet axis) => (m.UnknownEnd & axis) == AxisSet.None ? Shown.Mm(value) : Shown.Nothing;
    }

    /// <summary>The nearest place on a motion of the picture.</summary>
    internal Point2 NearestOn(int motion, Point2 place) => Moves.NearestOn(motion, place);
}
