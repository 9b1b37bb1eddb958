using Avalonia;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The pixels of a frame that are drawn on, as a few rectangles.</summary>
internal sealed class Damage(PixelSize size)
{
    // Beyond this number, one rectangle around all of them costs less than to pass each on.
    private const int Most = 8;
    private readonly List<PixelRect> _rects = [];

    /// <summary>The rectangles, inside the frame.</summary>
    public IReadOnlyList<PixelRect> Rects => _rects;

    /// <summary>Adds the whole frame.</summary>
    public void All()
    {
        _rects.Clear();
        _rects.Add(new(size));
    }

    /// <summary>Adds a rectangle.</summary>
    public void Add(SKRectI rect)
    {
        var added = new PixelRect(rect.Left, rect.Top, rect.Width, rect.Height).Intersect(new(size));
        if (added.Width <= 0 || added.Height <= 0 || _rects.Exists(r => r.Contains(added)))
        {
            return;
        }

        _rects.RemoveAll(added.Contains);
        _rects.Add(added);
        if (_rects.Count > Most)
        {
            var around = _rects.Aggregate((a, b) => a.Union(b));
            _rects.Clear();
            _rects.Add(around);
        }
    }
}
