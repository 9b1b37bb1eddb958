namespace ErrorMatching.Hmi;

/// <summary>A picture of single pixels, for what has too many lines to be drawn one by one as shapes: a line costs here what its pixels cost.</summary>
internal sealed class PixelCanvas
{
    private int[] _pixels = [];

    /// <summary>Width in pixels.</summary>
    public int Width { get; private set; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; private set; }

    /// <summary>The pixels, row by row from above; each with opacity, red, green and blue in its bytes.</summary>
    public ReadOnlySpan<int> Pixels => _pixels.AsSpan(0, Width * Height);

    /// <summary>The same as an array, which may be longer.</summary>
    public int[] Memory => _pixels;

    /// <summary>Wipes it.</summary>
    public void Clear(int width, int height)
    {
        (Width, Height) = (width, height);
        if (_pixels.Length < width * height)
        {
            _pixels = new int[width * height];
        }
        else
        {
            Array.Clear(_pixels, 0, width * height);
        }
    }

    /// <summary>Draws a line, places in pixels.</summary>
    /// <param name="x1">Where it begins.</param>
    /// <param name="y1">Where it begins.</param>
    /// <param name="x2">Where it ends.</param>
    /// <param name="y2">Where it ends.</param>
    /// <param name="color">Its color.</param>
    /// <param name="thickness">Its thickness in pixels.</param>
    /// <param name="isDashed">True for a dashed line, which goes under all others.</param>
    public void Line(double x1, double y1, double x2, double y2, int color, int thickness, bool isDashed)
    {
        var steps = (int)Math.Ceiling(Math.Max(Math.Abs(x2 - x1), Math.Abs(y2 - y1)));
        var (dx, dy) = steps == 0 ? (0, 0) : ((x2 - x1) / steps, (y2 - y1) / steps);
        for (var i = 0; i <= steps; i++)
        {
            var (x, y) = ((int)Math.Floor(x1 + (i * dx)), (int)Math.Floor(y1 + (i * dy)));
            if (isDashed)
            {
                // By place and not by length, so that pieces of a pixel are dashed as one line.
                if ((x + y & int.MaxValue) % (DrawnSizes.RapidDash + DrawnSizes.RapidGap) < DrawnSizes.RapidDash && Has(x, y) && _pixels[(y * Width) + x] == 0)
                {
                    _pixels[(y * Width) + x] = color;
                }
            }
            else if (thickness == 1)
            {
                if (Has(x, y))
                {
                    _pixels[(y * Width) + x] = color;
                }
            }
            else
            {
                Square(x - ((thickness - 1) / 2), y - ((thickness - 1) / 2), thickness, color);
            }
        }
    }

    /// <summary>Half the width of a disk in each of its rows from the middle on, in pixels.</summary>
    public static int[] Disk(double radius) => [.. Enumerable.Range(0, (int)Math.Max(1, radius) + 1).Select(row => (int)Math.Sqrt(Math.Max(0, (Math.Max(1, radius) * Math.Max(1, radius)) - (row * row))))];

    /// <summary>Draws a disk, its middle in pixels.</summary>
    public void Dot(int x, int y, int color, int[] disk)
    {
        for (var row = 1 - disk.Length; row < disk.Length; row++)
        {
            var half = disk[Math.Abs(row)];
            var (from, to) = (Math.Max(0, x - half), Math.Min(Width - 1, x + half));
            for (var at = ((y + row) * Width) + from; (uint)(y + row) < (uint)Height && from <= to; from++, at++)
            {
                _pixels[at] = color;
            }
        }
    }

    private void Square(int left, int top, int size, int color)
    {
        var (from, to) = (Math.Max(0, left), Math.Min(Width, left + size));
        for (var y = Math.Max(0, top); y < Math.Min(Height, top + size) && from < to; y++)
        {
            _pixels.AsSpan((y * Width) + from, to - from).Fill(color);
        }
    }

    private bool Has(int x, int y) => (uint)x < (uint)Width && (uint)y < (uint)Height;
}
