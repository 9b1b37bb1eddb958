using Avalonia;

namespace ErrorMatching.Hmi;

/// <summary>A pixel buffer for drawings with too many lines to draw as shapes. A line costs only its pixels.</summary>
internal sealed class PixelCanvas
{
    // Columns are grouped, and each group knows which of its rows are drawn on: what lies outside is neither cleared, copied nor shown. A
    // whole screen of 3840 x 2160 has 33 MB, and each pass over it takes several milliseconds.
    private const int GroupBits = 6;
    private int[] _pixels = [];
    private (int Low, int High)[] _groups = [];

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>The pixels, row by row from the top. The bytes of each are alpha, red, green and blue.</summary>
    public ReadOnlySpan<int> Pixels => _pixels.AsSpan(0, Width * Height);

    /// <summary>The backing array of <see cref="Pixels"/>; it may be longer.</summary>
    public int[] Memory => _pixels;

    /// <summary>Rectangles that contain everything that is drawn; they do not overlap.</summary>
    public IEnumerable<PixelRect> Touched => _groups
        .Select((rows, i) => (Left: i << GroupBits, rows.Low, rows.High))
        .Where(g => g.Low <= g.High)
        .Select(g => new PixelRect(g.Left, g.Low, Math.Min(1 << GroupBits, Width - g.Left), g.High - g.Low + 1));

    /// <summary>Sets the size and clears all pixels.</summary>
    public void Clear(int width, int height)
    {
        foreach (var rect in Touched)
        {
            for (var row = rect.Y; row < rect.Bottom; row++)
            {
                Array.Clear(_pixels, (row * Width) + rect.X, rect.Width);
            }
        }

        (Width, Height) = (width, height);
        if (_pixels.Length < width * height)
        {
            _pixels = new int[width * height];
        }

        _groups = new (int, int)[(width >> GroupBits) + 1];
        Array.Fill(_groups, (int.MaxValue, -1));
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
        var before = (thickness - 1) / 2;
        Touch(
            Pixel(Math.Min(x1, x2)) - before,
            Pixel(Math.Min(y1, y2)) - before,
            Pixel(Math.Max(x1, x2)) + thickness,
            Pixel(Math.Max(y1, y2)) + thickness);
        if (isDashed)
        {
            Dashed(x1, y1, x2, y2, color);
        }
        else if (Math.Abs(y2 - y1) >= Math.Abs(x2 - x1))
        {
            Steep(x1, y1, x2, y2, color, thickness);
        }
        else
        {
            Flat(x1, y1, x2, y2, color, thickness);
        }
    }

    /// <summary>Half the width of a disk in each row, from the center outwards, in pixels.</summary>
    public static int[] Disk(double radius) => [
        .. Enumerable.Range(0, (int)Math.Max(1, radius) + 1).Select(
            row => (int)Math.Sqrt(Math.Max(0, (Math.Max(1, radius) * Math.Max(1, radius)) - (row * row))))];

    /// <summary>Draws a disk. The center is in pixels.</summary>
    public void Dot(int x, int y, int color, int[] disk)
    {
        var reach = disk.Length - 1;
        Touch(x - disk[0], y - reach, x + disk[0], y + reach);
        for (var row = Math.Max(-reach, -y); row <= Math.Min(reach, Height - 1 - y); row++)
        {
            var half = disk[Math.Abs(row)];
            Run(y + row, Math.Max(0, x - half), Math.Min(Width - 1, x + half), color);
        }
    }

    // One run of pixels in each row, and squares at the ends.
    private void Steep(double x1, double y1, double x2, double y2, int color, int thickness)
    {
        var before = (thickness - 1) / 2;
        var slope = y1 == y2 ? 0 : (x2 - x1) / (y2 - y1);
        var (low, high, left, right) = (Math.Min(y1, y2), Math.Max(y1, y2), Math.Min(x1, x2), Math.Max(x1, x2));
        for (int row = Math.Max(0, Pixel(low)), last = Math.Min(Height - 1, Pixel(high)); row <= last; row++)
        {
            var x = Pixel(Math.Clamp(x1 + ((row + 0.5 - y1) * slope), left, right)) - before;
            Run(row, Math.Max(0, x), Math.Min(Width, x + thickness) - 1, color);
        }

        if (thickness > 1)
        {
            Square(Pixel(x1) - before, Pixel(y1) - before, thickness, color);
            Square(Pixel(x2) - before, Pixel(y2) - before, thickness, color);
        }
    }

    private void Flat(double x1, double y1, double x2, double y2, int color, int thickness)
    {
        var before = (thickness - 1) / 2;
        var slope = (y2 - y1) / (x2 - x1);
        var (low, high, left, right) = (Math.Min(y1, y2), Math.Max(y1, y2), Math.Min(x1, x2), Math.Max(x1, x2));
        for (int column = Math.Max(0, Pixel(left)), last = Math.Min(Width - 1, Pixel(right)); column <= last; column++)
        {
            var y = Pixel(Math.Clamp(y1 + ((column + 0.5 - x1) * slope), low, high)) - before;
            var end = Math.Min(Height, y + thickness);
            for (var row = Math.Max(0, y); row < end; row++)
            {
                _pixels[(row * Width) + column] = color;
            }
        }

        if (thickness > 1)
        {
            Square(Pixel(x1) - before, Pixel(y1) - before, thickness, color);
            Square(Pixel(x2) - before, Pixel(y2) - before, thickness, color);
        }
    }

    // Dash by position, not by length: consecutive pieces of less than a pixel then look like one dashed line.
    private void Dashed(double x1, double y1, double x2, double y2, int color)
    {
        var steps = (int)Math.Ceiling(Math.Max(Math.Abs(x2 - x1), Math.Abs(y2 - y1)));
        var (dx, dy) = steps == 0 ? (0, 0) : ((x2 - x1) / steps, (y2 - y1) / steps);
        for (var i = 0; i <= steps; i++)
        {
            var (x, y) = (Pixel(x1 + (i * dx)), Pixel(y1 + (i * dy)));
            if ((x + y & int.MaxValue) % (DrawnSizes.RapidDash + DrawnSizes.RapidGap) < DrawnSizes.RapidDash
                && (uint)x < (uint)Width
                && (uint)y < (uint)Height
                && _pixels[(y * Width) + x] == 0)
            {
                _pixels[(y * Width) + x] = color;
            }
        }
    }

    private void Square(int left, int top, int size, int color)
    {
        var (from, to) = (Math.Max(0, left), Math.Min(Width, left + size) - 1);
        for (var y = Math.Max(0, top); y < Math.Min(Height, top + size); y++)
        {
            Run(y, from, to, color);
        }
    }

    private void Run(int row, int from, int to, int color)
    {
        var pixels = _pixels;
        for (int at = (row * Width) + from, end = (row * Width) + to; at <= end; at++)
        {
            pixels[at] = color;
        }
    }

    private void Touch(int left, int top, int right, int bottom)
    {
        if (right < 0 || left >= Width || bottom < 0 || top >= Height)
        {
            return;
        }

        (top, bottom) = (Math.Max(0, top), Math.Min(Height - 1, bottom));
        var last = Math.Min(Width - 1, right) >> GroupBits;
        for (var group = Math.Max(0, left) >> GroupBits; group <= last; group++)
        {
            ref var rows = ref _groups[group];
            rows = (Math.Min(rows.Low, top), Math.Max(rows.High, bottom));
        }
    }

    private static int Pixel(double coordinate) => (int)Math.Floor(coordinate);
}
