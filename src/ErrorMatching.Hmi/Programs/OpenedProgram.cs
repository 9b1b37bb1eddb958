using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>A program that was opened: its text, read line by line when it is looked at, its path, and which is which. It is never changed.</summary>
/// <remarks>Opening interprets the program; do it beside the screen. A program of a million blocks costs its bytes and about 60 bytes a block.</remarks>
public sealed class OpenedProgram
{
    /// <summary>So much of a line is shown; a line can be as long as a file.</summary>
    public const int MostShown = 400;

    private OpenedProgram(NcPath path)
    {
        Path = path;
        Moves = new(path);
        LongestLine = Enumerable.Range(0, Count).Select(b => Math.Min(MostShown + 1, Path.Program[b].Length)).DefaultIfEmpty().Max();
    }

    /// <summary>What it does.</summary>
    public NcPath Path { get; }

    /// <summary>Its path, as it is drawn.</summary>
    public MovePicture Moves { get; }

    /// <summary>Number of blocks.</summary>
    public int Count => Path.Program.BlockCount;

    /// <summary>So many characters are shown of the longest line, at most: a byte is no more than one.</summary>
    public int LongestLine { get; }

    /// <summary>Why it could not be followed to its end, or what it has that is not understood; null if all is well.</summary>
    public string? Problem => Path.Refusal is { } refusal
        ? CodeText.Of(refusal.Code, refusal.Message)
        : Path.Problems.Count > 0 ? Texts.Current.With("Program.Problems", Shown.Count(Path.Problems.Count), Shown.Id(Path.Problems[0].Block + 1)) : null;

    /// <summary>Opens a program.</summary>
    /// <param name="bytes">Its bytes. They are kept: do not change them afterwards.</param>
    /// <param name="dialect">What its words mean.</param>
    /// <param name="cancellation">Ends it before it is done.</param>
    /// <exception cref="NcException">It is too large.</exception>
    /// <exception cref="OperationCanceledException">It was ended.</exception>
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

        // Not in the middle of a character: bytes behind the first one of it begin with the bits 10.
        var length = MostShown;
        while (length > MostShown - 4 && (program.BytesOf(place)[length] & 0xC0) == 0x80)
        {
            length--;
        }

        return program.TextOf(place with { Length = length }) + "…";
    }

    /// <summary>The number of a block as it stands there, or its line where it has none.</summary>
    public string NameOf(int block) => Path.Program.NumberOf(Path.Program[block]) is { Length: > 0 } number ? number : Texts.Current.With("Program.Line", Shown.Id(block + 1));

    /// <summary>The motions of some blocks from the first to the last of them, in the order in which they are executed; null if there are none.</summary>
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

    /// <summary>True if anything moves in a range.</summary>
    public bool IsMoving(BlockRange range)
    {
        var block = range.First;
        while (block <= range.Last && Path.MotionOf(block) < 0)
        {
            block++;
        }

        return block <= range.Last;
    }

    /// <summary>A range without what moves nothing at its ends, comments for example; the same if nothing in it moves.</summary>
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

    /// <summary>What a block does, for people: its text, and where its last move ends.</summary>
    public string TellMotion(int motion)
    {
        var m = Path.Motions[motion];
        var feed = m.IsCut && m.Feed > 0 ? Texts.Current.With("Program.Feed", m.Feed.ToString("0.###", System.Globalization.CultureInfo.InvariantCulture)) : "";
        return $"{NameOf(m.Block)}\nX {Coordinate(m.End.X, AxisSet.X)}  Y {Coordinate(m.End.Y, AxisSet.Y)}  Z {Coordinate(m.End.Z, AxisSet.Z)} mm{feed}";

        string Coordinate(double value, AxisSet axis) => (m.UnknownEnd & axis) == AxisSet.None ? Shown.Mm(value) : Shown.Nothing;
    }

    /// <summary>Where a motion of the picture is nearest to a place.</summary>
    internal Point2 NearestOn(int motion, Point2 place) => Moves.NearestOn(motion, place);
}
