using System.Runtime.Intrinsics;
using Avalonia;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A pixel buffer for drawings with too many lines to draw as shapes. A line costs only its pixels.</summary>
internal sealed class PixelCanvas
{
    // The canvas is divided into tiles, and each knows whether it is drawn on: the others are neither cleared, copied nor shown. A whole
    // screen of 3840 x 2160 has 33 MB, and each pass over it takes several milliseconds.
    private const int TileBits = 5;

    // A line that is steeper than this, in rows for a column, is drawn column by column.
    private const double SteepFactor = 8;
    private int[] _pixels = [];
    private bool[] _tiles = [], _tilesBefore = [];
    private int _tilesAcross;

    // Rows that a polyline covers in each column and that are not drawn yet.
    private int[] _low = [], _high = [];

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>The pixels, row by row from the top. The bytes of each are alpha, red, green and blue.</summary>
    public ReadOnlySpan<int> Pixels => _pixels.AsSpan(0, Width * Height);

    /// <summary>The backing array of <see cref="Pixels"/>; it is longer.</summary>
    public int[] Memory => _pixels;

    /// <summary>Rectangles that contain everything that is drawn, and everything that was until it was cleared; they do not
    /// overlap.</summary>
    public IEnumerable<PixelRect> Changed => Rects(_tiles, _tilesBefore);

    /// <summary>Sets the size and clears all pixels.</summary>
    public void Clear(int width, int height)
    {
        foreach (var tile in Rects(_tiles, _tiles))
        {
            for (var row = tile.Y; row < tile.Bottom; row++)
            {
                Array.Clear(_pixels, (row * Width) + tile.X, tile.Width);
            }
        }

        if (_pixels.Length < (width * height) + Vector256<int>.Count)
        {
            _pixels = new int[(width * height) + Vector256<int>.Count];
        }

        if (Width != width)
        {
            (_low, _high) = (new int[width + Vector256<int>.Count], new int[width + Vector256<int>.Count]);
            Array.Fill(_low, int.MaxValue);
            Array.Fill(_high, -1);
        }

        (Width, Height, _tilesAcross) = (width, height, (width >> TileBits) + 1);
        var tiles = _tilesAcross * ((height >> TileBits) + 1);
        if (_tiles.Length != tiles)
        {
            (_tiles, _tilesBefore) = (new bool[tiles], new bool[tiles]);
        }

        (_tiles, _tilesBefore) = (_tilesBefore, _tiles);
        Array.Clear(_tiles);
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

    /// <summary>Draws the same as <see cref="Line"/> from point to point, in less time if the line goes up and down.</summary>
    /// <param name="points">The points, in units of <paramref name="scale"/> pixels. One that begins is not joined to the one
    /// before.</param>
    /// <param name="scale">Pixels per unit.</param>
    /// <param name="color">Color.</param>
    /// <param name="thickness">Thickness in pixels.</param>
    /// <param name="isDashed">True for dashed lines.</param>
    public void Lines(IReadOnlyList<(Point2 At, bool Begins)> points, double scale, int color, int thickness, bool isDashed)
    {
        for (var i = 1; i < points.Count; i++)
        {
            var ((a, _), (b, begins)) = (points[i - 1], points[i]);
            if (begins)
            {
                continue;
            }

            var (x1, y1, x2, y2) = (a.X * scale, a.Y * scale, b.X * scale, b.Y * scale);
            if (!isDashed && Math.Abs(y2 - y1) > SteepFactor * Math.Abs(x2 - x1))
            {
                Columns(x1, y1, x2, y2, color, thickness);
            }
            else
            {
                Line(x1, y1, x2, y2, color, thickness, isDashed);
            }
        }

        DrawColumns(color);
    }

    /// <summary>Half the width of a disk in each row, from the center outwards, in pixels.</summary>
    public static int[] Disk(double radius) => [
        .. Enumerable.Range(0, (int)Math.Max(1, radius) + 1).Select(
            row => (int)Math.Sqrt(Math.Max(0, (Math.Max(1, radius) * Math.Max(1, radius)) - (row * row))))];

    /// <summary>Draws a disk. The center is in pixels.</summary>
    public void Dot(int x, int y, int color, int[] disk)
    {
        var reach = disk.Length - 1;
        var (left, right) = (Math.Max(0, x - disk[0]), Math.Min(Width - 1, x + disk[0]));
        var (top, bottom) = (Math.Max(0, y - reach), Math.Min(Height - 1, y + reach));
        if (left > right || top > bottom)
        {
            return;
        }

        Touch(left, top, right, bottom);
        for (var row = top; row <= bottom; row++)
        {
            var half = disk[Math.Abs(row - y)];
            Run(row, Math.Max(left, x - half), Math.Min(right, x + half), color);
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
            var (from, to) = (Math.Max(0, x), Math.Min(Width, x + thickness) - 1);
            if (from <= to)
            {
                Touch(from, row, to, row);
                Run(row, from, to, color);
            }
        }

        if (thickness > 1)
        {
            Square(Pixel(x1) - before, Pixel(y1) - before, thickness, color);
            Square(Pixel(x2) - before, Pixel(y2) - before, thickness, color);
        }
    }

    // The same pixels as of a steep line, as one run in each column, which is drawn later.
    private void Columns(double x1, double y1, double x2, double y2, int color, int thickness)
    {
        var before = (thickness - 1) / 2;
        var slope = (x2 - x1) / (y2 - y1);
        var (low, high, left, right) = (Math.Min(y1, y2), Math.Max(y1, y2), Math.Min(x1, x2), Math.Max(x1, x2));
        int At(int row) => Pixel(Math.Clamp(x1 + ((row + 0.5 - y1) * slope), left, right));
        for (int row = Math.Max(0, Pixel(low)), last = Math.Min(Height - 1, Pixel(high)); row <= last;)
        {
            // The last row in this column: about there, then exactly.
            var (column, end) = (At(row), last);
            if (At(last) != column)
            {
                end = Pixel(Math.Clamp(y1 - 0.5 + ((column + (slope > 0 ? 1 : 0) - x1) / slope), row, last - 1));
                while (At(end) != column)
                {
                    end--;
                }

                while (At(end + 1) == column)
                {
                    end++;
                }
            }

            Block(column - before, row, thickness, end, color);
            row = end + 1;
        }

        if (thickness > 1)
        {
            var (top1, top2) = (Pixel(y1) - before, Pixel(y2) - before);
            Block(Pixel(x1) - before, Math.Max(0, top1), thickness, Math.Min(Height, top1 + thickness) - 1, color);
            Block(Pixel(x2) - before, Math.Max(0, top2), thickness, Math.Min(Height, top2 + thickness) - 1, color);
        }
    }

    // Adds rows of some columns to those that are drawn later. If a gap is between them, one of the two must be drawn now.
    private void Block(int left, int top, int width, int bottom, int color)
    {
        if (top > bottom)
        {
            return;
        }

        for (int column = Math.Max(0, left), last = Math.Min(Width, left + width) - 1; column <= last; column++)
        {
            ref var low = ref _low[column];
            ref var high = ref _high[column];
            if (low <= high && (top > high + 1 || bottom < low - 1))
            {
                Touch(column, low, column, high);
                for (var row = low; row <= high; row++)
                {
                    _pixels[(row * Width) + column] = color;
                }

                (low, high) = (top, bottom);
            }
            else
            {
                (low, high) = (Math.Min(low, top), Math.Max(high, bottom));
            }
        }
    }

    // Several columns at once, row by row, which is the order of the memory.
    private void DrawColumns(int color)
    {
        var ink = Vector256.Create(color);
        for (var column = 0; column < Width; column += Vector256<int>.Count)
        {
            var (lows, highs) = (Vector256.Create(_low, column), Vector256.Create(_high, column));
            var (top, bottom) = (int.MaxValue, -1);
            for (var i = 0; i < Vector256<int>.Count; i++)
            {
                (top, bottom) = (Math.Min(top, lows[i]), Math.Max(bottom, highs[i]));
            }

            if (top > bottom)
            {
                continue;
            }

            Touch(column, top, Math.Min(column + Vector256<int>.Count, Width) - 1, bottom);
            for (var row = top; row <= bottom; row++)
            {
                var place = _pixels.AsSpan((row * Width) + column, Vector256<int>.Count);
                var at = Vector256.Create(row);
                var isCovered = Vector256.GreaterThanOrEqual(at, lows) & Vector256.LessThanOrEqual(at, highs);
                Vector256.ConditionalSelect(isCovered, ink, Vector256.Create<int>(place)).CopyTo(place);
            }

            Array.Fill(_low, int.MaxValue, column, Vector256<int>.Count);
            Array.Fill(_high, -1, column, Vector256<int>.Count);
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
            var (from, end) = (Math.Max(0, y), Math.Min(Height, y + thickness));
            if (from < end)
            {
                Touch(column, from, column, end - 1);
            }

            for (var row = from; row < end; row++)
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
                Touch(x, y, x, y);
                _pixels[(y * Width) + x] = color;
            }
        }
    }

    private void Square(int left, int top, int size, int color)
    {
        var (from, to) = (Math.Max(0, left), Math.Min(Width, left + size) - 1);
        var (first, last) = (Math.Max(0, top), Math.Min(Height, top + size) - 1);
        if (from > to || first > last)
        {
            return;
        }

        Touch(from, first, to, last);
        for (var y = first; y <= last; y++)
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

    // The tiles that one or the other names; those side by side in one rectangle.
    private IEnumerable<PixelRect> Rects(bool[] one, bool[] other)
    {
        for (var (row, y) = (0, 0); y < Height; (row, y) = (row + _tilesAcross, y + (1 << TileBits)))
        {
            for (var from = 0; from < _tilesAcross; from++)
            {
                var to = from;
                while (to < _tilesAcross && (one[row + to] || other[row + to]))
                {
                    to++;
                }

                if (to > from)
                {
                    var (left, right) = (from << TileBits, Math.Min(Width, to << TileBits));
                    yield return new(left, y, right - left, Math.Min(1 << TileBits, Height - y));
                    from = to;
                }
            }
        }
    }

    // Of pixels on the canvas.
    private void Touch(int left, int top, int right, int bottom)
    {
        for (int y = top >> TileBits, last = bottom >> TileBits; y <= last; y++)
        {
            for (int x = left >> TileBits, end = right >> TileBits; x <= end; x++)
            {
                _tiles[(y * _tilesAcross) + x] = true;
            }
        }
    }

    private static int Pixel(double coordinate) => (int)Math.Floor(coordinate);
}
