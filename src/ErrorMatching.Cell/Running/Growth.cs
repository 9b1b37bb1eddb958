namespace ErrorMatching.Cell;

/// <summary>Says whether a number grows: whether it is larger every third of a minute than the third before, for a whole minute. A number
/// that jumps and then shrinks does not grow.</summary>
/// <param name="third">A third of the time that it must grow for.</param>
internal sealed class Growth(TimeSpan third)
{
    /// <summary>A smaller number comes and goes.</summary>
    public const int Least = 10;

    private readonly List<(TimeSpan At, long Count)> _samples = [];
    private long? _noticed;

    /// <summary>Adds what the number is now.</summary>
    /// <param name="at">The time, by a clock that nobody sets.</param>
    /// <param name="count">The number.</param>
    /// <returns>True if it has grown for a minute, and has not become smaller than it was then.</returns>
    public bool Add(TimeSpan at, long count)
    {
        if (_samples is not [.., var last] || at - last.At >= third)
        {
            _samples.Add((at, count));
            if (_samples.Count > 4) _samples.RemoveAt(0);
        }

        if (count < (_noticed ?? 0)) _noticed = null;
        if (_noticed is null && count >= Least && _samples is [var a, var b, var c, var d]
            && a.Count < b.Count && b.Count < c.Count && c.Count < d.Count && d.Count <= count)
        {
            _noticed = count;
        }

        return _noticed is not null;
    }
}
