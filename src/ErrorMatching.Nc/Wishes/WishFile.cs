using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>A wish as a document, schema <c>errormatch/wish/1</c>. With it and the two programs, the proof can be repeated without
/// knowing how the result was made.</summary>
/// <remarks>Lengths are in mm. A wish names motions by their position in the path. Block and line are included for people; a wish whose
/// positions and lines disagree is refused.</remarks>
public sealed class WishFile
{
    /// <summary>Name and version of the document.</summary>
    public const string Schema = "errormatch/wish/1";

    /// <summary>Maximum size of a document, in bytes: a million elements.</summary>
    public const int MaxBytes = 1 << 28;

    private readonly WishedMotion[] _motions;

    internal WishFile(
        string dialect, string beforeSha256, double leastIncrementMm, string? marker, DisplacementWish wish, WishedMotion[] motions)
    {
        Dialect = dialect;
        BeforeSha256 = beforeSha256;
        LeastIncrementMm = leastIncrementMm;
        Marker = marker;
        Wish = wish;
        _motions = motions;
    }

    /// <summary>The dialect in which both programs are read.</summary>
    public string Dialect { get; }

    /// <summary>The block skip switch for both programs; unstated if they do not depend on it, or if the dialect's file states
    /// it.</summary>
    public BlockSkip BlockSkip { get; init; }

    /// <summary>The tools' radii for cutter compensation in both programs, as far as they were stated.</summary>
    public ToolRadii ToolRadii { get; init; } = ToolRadii.None;

    /// <summary>Values of variables that only the machine knows, as they were stated for both programs.</summary>
    public AssumedValues Assumed { get; init; } = AssumedValues.None;

    /// <summary>SHA-256 of the wish's original program, and of the programs that it calls (<see cref="NcPath.Sha256"/>).</summary>
    public string BeforeSha256 { get; }

    /// <summary>Increment to which new coordinates were rounded, mm.</summary>
    public double LeastIncrementMm { get; }

    /// <summary>The comment that was inserted as a separate line; null if there is none.</summary>
    public string? Marker { get; }

    /// <summary>The wish itself.</summary>
    public DisplacementWish Wish { get; }

    /// <summary>The motions that the wish names, in the order of <see cref="Wish"/>.</summary>
    internal IReadOnlyList<WishedMotion> Motions => _motions;

    /// <summary>Creates the document of a wish.</summary>
    /// <param name="before">The original program, interpreted.</param>
    /// <param name="wish">The wish; positions of motions are those of <paramref name="before"/>.</param>
    /// <param name="leastIncrementMm">Increment to which new coordinates were rounded.</param>
    /// <param name="marker">The inserted comment, or null.</param>
    public static WishFile Of(NcPath before, DisplacementWish wish, double leastIncrementMm, string? marker = null)
    {
        var named = new WishedMotion[Math.Max(wish.Elements.Count, wish.EndPoints.Count)];
        for (var i = 0; i < named.Length; i++)
        {
            var motion = wish.Elements.Count > 0 ? wish.Elements[i].Motion : wish.EndPoints[i];
            var block = before.Program[before.Motions[motion].Block];
            named[i] = new(before.Program.NumberOf(block), block.Line, motion, null);
        }

        return new(before.Dialect.Name, before.Sha256, leastIncrementMm, marker, wish, named)
        {
            BlockSkip = before.Dialect.BlockSkip,
            Assumed = before.Dialect.Assumed,
            ToolRadii = CompensatedPath.Concerns(before) ? before.Dialect.ToolRadii : ToolRadii.None,
        };
    }

    /// <summary>Reads a document.</summary>
    /// <param name="bytes">UTF-8 text.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="InputException">It is not JSON, does not follow this schema, or names a motion twice
    /// (<c>motion-twice</c>).</exception>
    public static WishFile Read(ReadOnlySpan<byte> bytes, string file) => WishReader.Read(bytes, file);

    /// <summary>Writes the document: UTF-8 without a byte order mark, one named motion per line.</summary>
    public void WriteTo(Stream stream) => WishWriter.Write(this, stream);

    /// <summary>Checks whether this wish belongs to a program, and if so, whether the program fits it.</summary>
    /// <param name="before">The program, interpreted in the wish's dialect.</param>
    /// <param name="file">Name of the wish's file for messages.</param>
    /// <exception cref="InputException">
    /// A motion is not in the program, or is in another line or block (<c>no-such-motion</c>); it is not a cut that can be displaced as
    /// an element (<c>no-element</c>); or the increment is coarser than the dialect's (<c>increment-too-coarse</c>).
    /// </exception>
    /// <returns>False if the SHA-256 of the program, or of one that it calls, differs.</returns>
    public bool IsAbout(NcPath before, string file)
    {
        if (before.Sha256 != BeforeSha256)
        {
            return false;
        }

        WishReader.CheckAgainst(this, before, file);
        return true;
    }
}

/// <summary>A motion as named in a wish.</summary>
/// <param name="Block">The N word of its block; empty if it has none.</param>
/// <param name="Line">The line of its block, from 1.</param>
/// <param name="Motion">Its position in the path.</param>
/// <param name="Source">Its place in the document; null for a wish that was not read.</param>
internal readonly record struct WishedMotion(string Block, int Line, int Motion, JsonItem? Source);
