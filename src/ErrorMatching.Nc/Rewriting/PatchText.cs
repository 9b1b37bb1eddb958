namespace ErrorMatching.Nc;

/// <summary>Stores the new texts of many patches in few memory blocks.</summary>
internal sealed class PatchText
{
    private const int PieceSize = 1 << 16;

    private byte[] _piece = [];
    private int _used;

    /// <summary>Copies a text and returns the stored copy.</summary>
    public ReadOnlyMemory<byte> Keep(ReadOnlySpan<byte> text)
    {
        if (_used + text.Length > _piece.Length)
        {
            (_piece, _used) = (new byte[Math.Max(PieceSize, text.Length)], 0);
        }

        text.CopyTo(_piece.AsSpan(_used));
        _used += text.Length;
        return _piece.AsMemory(_used - text.Length, text.Length);
    }
}
