using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>A long list in pieces of one size: it grows without copying, and can share equal pieces with another list.</summary>
internal sealed class Chunks<T>
    where T : struct
{
    private const int Shift = 13;
    private const int Size = 1 << Shift;

    // Most programs are short, and many lists live at once: the first piece begins with this many items and doubles.
    private const int First = 128;

    private readonly Chunks<T>? _like;
    private T[][] _chunks = new T[16][];
    private T[] _last = [];
    private int _used;

    // The end of the piece to which items are added.
    private int _end;

    // From the seam on, items are further back by a gap, because their pieces came from another list.
    private int _seam = int.MaxValue;
    private int _gap;

    /// <summary>Creates an empty list.</summary>
    /// <param name="like">A list whose pieces are shared if they are equal, byte for byte.</param>
    /// <param name="inPlace">True if each item is stored at the same place as that list's item at the same position.</param>
    public Chunks(Chunks<T>? like = null, bool inPlace = false)
    {
        _like = like;
        if (inPlace && like is not null)
        {
            (_seam, _gap) = (like._seam, like._gap);
        }
    }

    public int Count => _used > _seam ? _used - _gap : _used;

    public ref T this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            var place = PlaceOf(index);
            return ref _chunks[place >> Shift][place & (Size - 1)];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(in T item)
    {
        if (_used == _end)
        {
            Grow();
        }

        _last[_used & (Size - 1)] = item;
        _used++;
    }

    /// <summary>Appends the items of the similar list from this list's end up to a position. This list must have been created in place.
    /// Shares whole pieces.</summary>
    public void TakeOver(int end)
    {
        while (Count < end)
        {
            if (_used == _end)
            {
                Grow();
            }

            var (piece, at, items) = (_used >> Shift, _used & (Size - 1), Math.Min(_end - _used, end - Count));
            if (items == Size)
            {
                _chunks[piece] = _like!._chunks[piece];
            }
            else
            {
                Array.Copy(_like!._chunks[piece], at, _last, at, items);
            }

            _used += items;
        }
    }

    /// <summary>Takes over the pieces of another list, which must get no more items. Call it only once.</summary>
    /// <param name="other">The list.</param>
    /// <param name="from">The first item to take.</param>
    public void Join(Chunks<T> other, int from)
    {
        var (own, others) = (PiecesOf(_used), PiecesOf(other._used));
        (_seam, _gap) = (Count, (own << Shift) + from - Count);
        Array.Resize(ref _chunks, own + others + 1);
        Array.Copy(other._chunks, 0, _chunks, own, others);
        (_last, _used, _end) = (other._last, (own << Shift) + other._used, (own << Shift) + other._end);
    }

    /// <summary>Number of items from a position on that are at the same place of a piece shared with another list.</summary>
    public int SharedFrom(int index, Chunks<T> other)
    {
        var (mine, its) = (PlaceOf(index), other.PlaceOf(index));
        var isShared = ((mine ^ its) & (Size - 1)) == 0 && ReferenceEquals(_chunks[mine >> Shift], other._chunks[its >> Shift]);
        return isShared ? Math.Min(Size - (mine & (Size - 1)), Math.Min(EndBehind(index), other.EndBehind(index)) - index) : 0;
    }

    private int EndBehind(int index) => index < _seam ? Math.Min(_seam, Count) : Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int PlaceOf(int index) => index < _seam ? index : index + _gap;

    private static int PiecesOf(int items) => (items + Size - 1) >> Shift;

    private void Grow()
    {
        _used += _used == _seam ? _gap : 0;
        var piece = _used >> Shift;
        if (piece == _chunks.Length)
        {
            Array.Resize(ref _chunks, piece * 2);
        }

        if (_chunks[piece] is not null)
        {
            Array.Resize(ref _last, 2 * _last.Length);
        }
        else if (piece == 0)
        {
            _last = new T[First];
        }
        else if (!Share(piece - 1))
        {
            _last = new T[Size];
        }

        _chunks[piece] = _last;
        _end = Math.Min((piece << Shift) + _last.Length, _used < _seam ? _seam : int.MaxValue);
    }

    // The piece was just filled: if the other list has an equal one, this list shares it and reuses its own memory for the next.
    private bool Share(int piece)
    {
        if (_like is null || ((piece + 1) << Shift) > _like._used)
        {
            return false;
        }

        var other = _like._chunks[piece];
        if (!ReferenceEquals(_chunks[piece], other)
            && !System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(_last).SequenceEqual(
                System.Runtime.InteropServices.MemoryMarshal.AsBytes<T>(other)))
        {
            return false;
        }

        _chunks[piece] = other;
        return true;
    }
}
