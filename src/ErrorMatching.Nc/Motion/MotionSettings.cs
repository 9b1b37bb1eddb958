using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>The settings of motions, each stored once for all motions in sequence that share it.</summary>
internal sealed class MotionSettings
{
    private readonly RankedBits _areNew = new();
    private Setting[] _settings = new Setting[16];
    private int _count;
    private double _lastFeed;
    private int _lastFrame;

    /// <summary>The setting of a motion.</summary>
    public Setting this[int motion] => _settings[_areNew.CountTo(motion) - 1];

    /// <summary>True if no motion is in another frame than the first one.</summary>
    public bool HaveOneFrame => _lastFrame == 0;

    /// <summary>Appends the setting of the next motion.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(double feed, int frame)
    {
        var isNew = _count == 0 || _lastFeed != feed || _lastFrame != frame;
        if (isNew)
        {
            (_lastFeed, _lastFrame) = (feed, frame);
            Append(new(feed, frame));
        }

        _areNew.Add(isNew);
    }

    /// <summary>True if all motions have bitwise the same settings in another list.</summary>
    public bool SameAs(MotionSettings other)
    {
        var same = _count == other._count && _areNew.SameAs(other._areNew);
        for (var i = 0; same && i < _count; i++)
        {
            same = _settings[i].SameAs(other._settings[i]);
        }

        return same;
    }

    /// <summary>Appends the settings of motions that ran ahead, except the first of them, which only marks their start.</summary>
    /// <param name="ahead">The settings.</param>
    /// <param name="motions">Number of their motions, at least 2.</param>
    public void Join(MotionSettings ahead, int motions)
    {
        // The first of them can have the setting of the last one here. Whether the others start a new setting does not depend on earlier
        // motions.
        var setting = ahead._areNew[1] ? 1 : 0;
        Add(ahead._settings[setting].Feed, ahead._settings[setting].Frame);
        while (++setting < ahead._count)
        {
            Append(ahead._settings[setting]);
        }

        _areNew.AddFrom(ahead._areNew, 2, motions);
        (_lastFeed, _lastFrame) = (ahead._lastFeed, ahead._lastFrame);
    }

    /// <summary>Appends the settings of another list from a motion up to, not including, another. Both lists have the same setting at
    /// the motion before the first.</summary>
    public void TakeOver(MotionSettings like, int first, int end)
    {
        for (var setting = like._areNew.CountTo(first - 1); setting < like._areNew.CountTo(end - 1); setting++)
        {
            Append(like._settings[setting]);
        }

        _areNew.AddFrom(like._areNew, first, end);
        (_lastFeed, _lastFrame) = this[end - 1];
    }

    private void Append(Setting setting)
    {
        if (_count == _settings.Length)
        {
            Array.Resize(ref _settings, _count * 2);
        }

        _settings[_count++] = setting;
    }

    /// <summary>Settings that stay the same over many motions.</summary>
    /// <param name="Feed">The last programmed feed, mm/min.</param>
    /// <param name="Frame">Number of changes of offsets and origins so far.</param>
    public readonly record struct Setting(double Feed, int Frame)
    {
        /// <summary>True if both are bitwise equal.</summary>
        public bool SameAs(in Setting other) =>
            Frame == other.Frame && BitConverter.DoubleToInt64Bits(Feed) == BitConverter.DoubleToInt64Bits(other.Feed);
    }
}
