namespace ErrorMatching.Cell;

/// <summary>A set of numbers that are mostly consecutive, at one bit each.</summary>
internal sealed class NumberSet
{
    private const int BitsOfPage = 16;
    private readonly Dictionary<long, ulong[]> _pages = [];

    /// <summary>How many numbers are in it.</summary>
    public long Count { get; private set; }

    /// <summary>True if a number is in it.</summary>
    public bool Contains(long number) =>
        _pages.TryGetValue(number >> BitsOfPage, out var page) && (page[WordOf(number)] & BitOf(number)) != 0;

    /// <summary>Adds a number.</summary>
    public void Add(long number)
    {
        if (Contains(number)) return;
        var key = number >> BitsOfPage;
        if (!_pages.TryGetValue(key, out var page)) _pages.Add(key, page = new ulong[1 << (BitsOfPage - 6)]);
        page[WordOf(number)] |= BitOf(number);
        Count++;
    }

    private static int WordOf(long number) => (int)(number & ((1 << BitsOfPage) - 1)) >> 6;

    private static ulong BitOf(long number) => 1UL << (int)(number & 63);
}
