namespace ErrorMatching.Hmi;

/// <summary>A pixel buffer for drawings with too many lines to draw as shapes. A line costs only its pixels.</summary>
internal sealed class PixelCanvas
{
    private int[] _pixels = [];

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>The pixels, row by row from the top. The bytes of each are alpha, red, green and blue.</summary>
    public ReadOnlySpan<int> Pixels => _pixels.AsSpan(0, Width * Height);

    /// <summary>The backing array of <see cref="Pixels"/>; it may be longer.</summary>
    public int[] Memory => _pixels;

    /// <summary>Sets the size and clears all pixels.</summary>
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

    /// <summary>Draws a line. Coordinates are in pixels.</summary>
    /// <param name="x1">Start, x.</param>
    /// <param name="y1">Start, y.</param>
    /// <param name="x2">End, x.</param>
    /// <param name="y2">End, y.</param>
    /// <param name="color">Color.</param>
    /// <param name="thickness">Thickness in pixels.</param>
    /// <param name="isDashed">True for a dashed line, which is drawn below all others.</param>
    public void Line(double x1, double y1, double x2, double y2, int color, int thickness, bool isDashed)
    {
        var steps = (int)Math.Ceiling(Math.Max(Math.Abs(x2 - x1), Math.Abs(y2 - y1)));
        var (dx, dy) = steps == 0 ? (0, 0) : ((x2 - x1) / steps, (y2 - y1) / steps);
        for (var i = 0; i <= steps; i++)
        {
            var (x, y) = ((int)Math.Floor(x1 + (i * dx)), (int)Math.Floor(y1 + (i * dy)));
            if (isDashed)
            {
                // Dash by position, not by length: consecutive pieces of less than a pixel then look like one dashed line.
                if ((x + y & int.MaxValue) % (DrawnSizes.RapidDash + DrawnSizes.RapidGap) < DrawnSizes.RapidDash
                    && Has(x, y)
                    && _pixels[(y * Width) + x] == 0)
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

    /// <summary>Half the width of a disk in each row, from the center outwards, in pixels.</summary>
    public static int[] Disk(double radius) => [
        .. Enumerable.Range(0, (int)Math.Max(1, radius) + 1).Select(
            row => (int)Math.Sqrt(Math.Max(0, (Math.Max(1, radius) * Math.Max(1, radius)) - (row * row))))];

    /// <summary>Draws a disk. The center is in pixels.</summary>
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
