using System.Security.Cryptography;
using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>
/// A wish as a document, schema <c>errormatch/wish/1</c>: with it and the two programs a proof can be made again,
/// without knowing how the result came about.
/// </summary>
/// <remarks>Lengths in mm. A wish names motions by their position in the path; block and line stand beside it for people, and a wish whose
/// positions and lines disagree is refused.</remarks>
public sealed class WishFile
{
    /// <summary>Name and version of the document.</summary>
    public const string Schema = "errormatch/wish/1";

    /// <summary>Largest document that is read, in bytes: a million elements.</summary>
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

    /// <summary>The control in whose language both programs are read.</summary>
    public string Dialect { get; }

    /// <summary>
    /// How the switch for block skip stands in both programs; unstated where they do not depend on it, or the dialect's file says so.
    /// </summary>
    public BlockSkip BlockSkip { get; init; }

    /// <summary>SHA-256 of the program that the wish is about, 64 lower-case hexadecimal digits.</summary>
    public string BeforeSha256 { get; }

    /// <summary>Increment to which new coordinates were rounded, mm.</summary>
    public double LeastIncrementMm { get; }

    /// <summary>The comment that was inserted as a line of its own; null where none was.</summary>
    public string? Marker { get; }

    /// <summary>What was asked.</summary>
    public DisplacementWish Wish { get; }

    /// <summary>The motions that the wish names, in the order of <see cref="Wish"/>.</summary>
    internal IReadOnlyList<WishedMotion> Motions => _motions;

    /// <summary>The file of a wish.</summary>
    /// <param name="before">The program that it is about, interpreted.</param>
    /// <param name="wish">What was asked; positions of motions are those of <paramref name="before"/>.</param>
    /// <param name="leastIncrementMm">Increment to which new coordinates were rounded.</param>
    /// <param name="marker">The comment that was inserted, or null.</param>
    public static WishFile Of(NcPath before, DisplacementWish wish, double leastIncrementMm, string? marker = null)
    {
        var named = new WishedMotion[Math.Max(wish.Elements.Count, wish.EndPoints.Count)];
        for (var i = 0; i < named.Length; i++)
        {
            var motion = wish.Elements.Count > 0 ? wish.Elements[i].Motion : wish.EndPoints[i];
            var block = before.Program[before.Motions[motion].Block];
            named[i] = new(before.Program.NumberOf(block), block.Line, motion, null);
        }

        return new(before.Dialect.Name, Sha256(before.Program), leastIncrementMm, marker, wish, named)
        {
            BlockSkip = before.Dialect.BlockSkip,
        };
    }

    /// <summary>Reads a document.</summary>
    /// <param name="bytes">UTF-8 text.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="JsonDocumentException">It is no JSON, not of this schema, or names a motion twice
    /// (<c>motion-twice</c>).</exception>
    public static WishFile Read(ReadOnlySpan<byte> bytes, string file) => WishReader.Read(bytes, file);

    /// <summary>Writes the document: UTF-8 without a byte order mark, one named motion a line.</summary>
    public void WriteTo(Stream stream) => WishWriter.Write(this, stream);

    /// <summary>Whether this wish is about a program, and if so, whether it can be.</summary>
    /// <param name="before">The program, interpreted in the wish's dialect.</param>
    /// <param name="file">Name of the wish's file for messages.</param>
    /// <exception cref="JsonDocumentException">
    /// A motion is none of the program's, or stands in another line or block (<c>no-such-motion</c>); it is no cut that could be displaced
    /// as an element (<c>no-element</c>); or the increment is coarser than the dialect's (<c>increment-too-coarse</c>).
    /// </exception>
    /// <returns>False if the program is another one, by its SHA-256.</returns>
    public bool IsAbout(NcPath before, string file)
    {
        if (Sha256(before.Program) != BeforeSha256)
        {
            return false;
        }

        WishReader.CheckAgainst(this, before, file);
        return true;
    }

    private static string Sha256(NcProgram program) => Convert.ToHexStringLower(SHA256.HashData(program.Bytes.Span));
}
