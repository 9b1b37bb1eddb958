using System.Buffers.Binary;
using System.Text;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Reads names, style and characters of the faces of a font file, and nothing else of it: a file may have 20 MB, and there may be
/// hundreds.</summary>
/// <remarks>OpenType 1.9: the header of a collection, the table directory, and the tables <c>name</c>, <c>OS/2</c> and
/// <c>cmap</c>.</remarks>
internal sealed class FontFile : IDisposable
{
    private const uint Collection = 0x74746366, Name = 0x6E616D65, Style = 0x4F532F32, Characters = 0x636D6170;
    private const int MostFaces = 64, MostTables = 128, MostTable = 8 << 20;
    private readonly FileStream _file;

    /// <summary>Opens a file.</summary>
    public FontFile(string path) =>
        _file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);

    /// <summary>The faces of the file, in order.</summary>
    /// <exception cref="InvalidDataException">It is no font.</exception>
    public IReadOnlyList<FontFace> Faces()
    {
        var head = Bytes(0, 12);
        if (BinaryPrimitives.ReadUInt32BigEndian(head) != Collection)
        {
            return [Face(0, 0)];
        }

        var count = (int)Math.Min(MostFaces, BinaryPrimitives.ReadUInt32BigEndian(head.AsSpan(8)));
        var offsets = Bytes(12, 4 * count);
        return [.. Enumerable.Range(0, count).Select(i => Face(i, BinaryPrimitives.ReadUInt32BigEndian(offsets.AsSpan(4 * i))))];
    }

    /// <summary>The table of characters of a face.</summary>
    /// <exception cref="InvalidDataException">The file has changed, and is no font any more.</exception>
    public byte[] CharactersOf(FontFace face) => Table(Directory(face.Offset), Characters) ?? [];

    public void Dispose() => _file.Dispose();

    private FontFace Face(int index, long offset)
    {
        var directory = Directory(offset);
        var style = Table(directory, Style);
        var names = Names(Table(directory, Name) ?? throw new InvalidDataException("The face has no names."));
        if (style is not { Length: >= 64 })
        {
            return new(_file.Name, index, offset, names, 400, 5, FontStyle.Normal, IsSans: false, IsTraditional: false);
        }

        // Panose: the family is Latin text (2), and the style of its serifs is 11 to 15, which have none.
        var (family, serifs) = (style[32], style[33]);
        var selection = BinaryPrimitives.ReadUInt16BigEndian(style.AsSpan(62));
        var pages = style.Length >= 82 ? BinaryPrimitives.ReadUInt32BigEndian(style.AsSpan(78)) : 0;
        return new(
            _file.Name,
            index,
            offset,
            names,
            BinaryPrimitives.ReadUInt16BigEndian(style.AsSpan(4)),
            BinaryPrimitives.ReadUInt16BigEndian(style.AsSpan(6)),
            (selection & 1) != 0 ? FontStyle.Italic : (selection & (1 << 9)) != 0 ? FontStyle.Oblique : FontStyle.Normal,
            IsSans: family == 2 && serifs is >= 11 and <= 15,
            IsTraditional: (pages & (1 << 20)) != 0);
    }

    private byte[] Directory(long offset)
    {
        var count = BinaryPrimitives.ReadUInt16BigEndian(Bytes(offset, 12).AsSpan(4));
        return count <= MostTables ? Bytes(offset + 12, 16 * count) : throw new InvalidDataException("The face has too many tables.");
    }

    private byte[]? Table(byte[] directory, uint tag)
    {
        for (var i = 0; i < directory.Length; i += 16)
        {
            if (BinaryPrimitives.ReadUInt32BigEndian(directory.AsSpan(i)) == tag)
            {
                var length = BinaryPrimitives.ReadUInt32BigEndian(directory.AsSpan(i + 12));
                return length <= MostTable
                    ? Bytes(BinaryPrimitives.ReadUInt32BigEndian(directory.AsSpan(i + 8)), (int)length)
                    : throw new InvalidDataException("A table of the face is too large.");
            }
        }

        return null;
    }

    // The family as the system names it (1) and the typographic one (16), in every language that is stored as UTF-16.
    private static SortedSet<string> Names(byte[] table)
    {
        var found = new SortedSet<string>(StringComparer.OrdinalIgnoreCase);
        if (table.Length < 6)
        {
            throw new InvalidDataException("The names of the face are cut off.");
        }

        var (count, texts) = (BinaryPrimitives.ReadUInt16BigEndian(table.AsSpan(2)), BinaryPrimitives.ReadUInt16BigEndian(table.AsSpan(4)));
        for (var at = 6; at < 6 + (12 * count) && at + 12 <= table.Length; at += 12)
        {
            int Field(int i) => BinaryPrimitives.ReadUInt16BigEndian(table.AsSpan(at + (2 * i)));
            var start = texts + Field(5);
            if (Field(0) is 0 or 3 && Field(3) is 1 or 16 && start + Field(4) <= table.Length)
            {
                found.Add(Encoding.BigEndianUnicode.GetString(table, start, Field(4)));
            }
        }

        return found.Count > 0 ? found : throw new InvalidDataException("The face has no family.");
    }

    private byte[] Bytes(long offset, int count)
    {
        if (offset + count > _file.Length)
        {
            throw new InvalidDataException("The file is cut off.");
        }

        var bytes = new byte[count];
        _file.Position = offset;
        _file.ReadExactly(bytes);
        return bytes;
    }
}
