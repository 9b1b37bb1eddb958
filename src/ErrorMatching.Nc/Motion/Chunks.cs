namespace ErrorMatching.Nc;

/// <summary>A long list in pieces of one size: it grows without copying, and equal pieces can be shared with another list.</summary>
internal sealed class Chunks<T>
    where T : struct
{
    private const int Shift = 13;
    private const int Size = 1 << Shift;

    private readonly Chunks<T>? _like;
    private T[][] _chunks = new T[16][];
    private T[] _last = [];

    /// <summary>An empty list.</summary>
    /// <param name="like">A list whose pieces are taken over where they are equal, byte for byte.</param>
    public Chunks(Chunks<T>? like = null) => _like = like;

    public int Count { get; private set; }

    public ref T this[int index] => ref _chunks[index >> Shift][index & (Size - 1)];

    public void Add(in T item)
    {
        var at = Count & (Size - 1);
        if (at == 0)
        {
            Grow();
        }

        _last[at] = item;
        Count++;
    }

    private void Grow()
    {
        var piece = Count >> Shift;
        if (piece == _chunks.Length)
        {
            Array.Resize(ref _chunks, piece * 2);
        }

        var spare = piece > 0 && Share(piece - 1) ? _last : new T[Size];
        _chunks[piece] = _last = spare;
    }

    // The piece just filled: if the other list has the same, its own memory is free for the next.
    private bool Share(int piece)
    {
        if (_like is null || ((piece + 1) << Shift) > _like.Count)
        {
            return false;
        }

        var other = _like._chunks[piece];
        if (!System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(_last).SequenceEqual(System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(other)))
        {
            return false;
        }

        _chunks[piece] = other;
        return true;
    }
}
