using System.Runtime.InteropServices;
using HarfBuzzSharp;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A font file in memory that never moves and is never freed: shaping and drawing both read it, and their caches refer to it
/// until the process ends.</summary>
internal sealed class FontMemory
{
    private static readonly List<FontMemory> Owned = [];
    private readonly byte[] _bytes;

    private FontMemory(byte[] bytes)
    {
        _bytes = bytes;
        Address = Marshal.UnsafeAddrOfPinnedArrayElement(bytes, 0);
        Shaped = new Blob(Address, bytes.Length, MemoryMode.ReadOnly);
        Drawn = SKData.Create(Address, bytes.Length);
    }

    /// <summary>The memory for HarfBuzz.</summary>
    public Blob Shaped { get; }

    /// <summary>The memory for Skia.</summary>
    public SKData Drawn { get; }

    private nint Address { get; }

    /// <summary>Reads a stream to its end.</summary>
    /// <exception cref="InvalidDataException">The font is larger than <see cref="FontFolders.MostBytes"/>.</exception>
    public static FontMemory Of(Stream stream)
    {
        using var copy = new MemoryStream();
        var piece = new byte[1 << 16];
        for (int read; (read = stream.Read(piece)) > 0;)
        {
            copy.Write(piece, 0, read);
            if (copy.Length > FontFolders.MostBytes)
            {
                throw new InvalidDataException($"A font has more than {FontFolders.MostBytes} bytes.");
            }
        }

        var pinned = GC.AllocateUninitializedArray<byte>((int)copy.Length, pinned: true);
        copy.GetBuffer().AsSpan(0, pinned.Length).CopyTo(pinned);
        var memory = new FontMemory(pinned);
        lock (Owned)
        {
            Owned.Add(memory);
        }

        return memory;
    }

    /// <summary>The bytes of a table, without a copy; empty if the face has no such table.</summary>
    public ReadOnlyMemory<byte> Table(Face face, uint tag)
    {
        char Letter(int shift) => (char)(tag >> shift & 0xFF);
        using var blob = face.ReferenceTable(new Tag(Letter(24), Letter(16), Letter(8), Letter(0)));
        var table = blob.AsSpan();
        if (table.IsEmpty)
        {
            return default;
        }

        ref var start = ref MemoryMarshal.GetReference(table);
        var offset = System.Runtime.CompilerServices.Unsafe.ByteOffset(ref MemoryMarshal.GetArrayDataReference(_bytes), ref start);
        return _bytes.AsMemory((int)offset, table.Length);
    }

    /// <summary>A stream over the whole file.</summary>
    public Stream Read() => new MemoryStream(_bytes, writable: false);
}
