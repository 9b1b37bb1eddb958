using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Imaging;

namespace ErrorMatching.Hmi;

/// <summary>The rows of a program as drawn: line number, name of the feature, and text. Each is drawn once, and copied while it is
/// visible.</summary>
public abstract class ProgramRows : Control
{
    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<ProgramRows, IBrush?>(nameof(Ink));

    public static readonly StyledProperty<IBrush?> NumberInkProperty = AvaloniaProperty.Register<ProgramRows, IBrush?>(nameof(NumberInk));

    public static readonly StyledProperty<IBrush?> GroundProperty = AvaloniaProperty.Register<ProgramRows, IBrush?>(nameof(Ground));

    public static readonly StyledProperty<IBrush?> ChosenGroundProperty = AvaloniaProperty.Register<ProgramRows, IBrush?>(
        nameof(ChosenGround));

    public static readonly StyledProperty<IBrush?> ChosenBrushProperty = AvaloniaProperty.Register<ProgramRows, IBrush?>(
        nameof(ChosenBrush));

    public static readonly StyledProperty<FontFamily> FontFamilyProperty = AvaloniaProperty.Register<ProgramRows, FontFamily>(
        nameof(FontFamily), FontFamily.Default);

    public static readonly StyledProperty<double> TextSizeProperty = AvaloniaProperty.Register<ProgramRows, double>(nameof(TextSize), 1);

    public static readonly StyledProperty<double> RowHeightProperty = AvaloniaProperty.Register<ProgramRows, double>(nameof(RowHeight), 1);

    // Width reserved for feature names, in multiples of the text size.
    private const int MostName = 6;

    // Rows are cached for this many screens.
    private const int MostScreens = 3;

    private static readonly Typeface NameFace = new(FontFamily.Default, FontStyle.Normal, FontWeight.SemiBold);
    private readonly Dictionary<int, DrawnLine> _rows = [];
    private readonly Dictionary<string, FormattedText> _names = [];
    private double _numberWidth, _nameWidth;

    static ProgramRows()
    {
        AffectsRender<ProgramRows>(
            InkProperty,
            NumberInkProperty,
            GroundProperty,
            ChosenGroundProperty,
            ChosenBrushProperty,
            FontFamilyProperty,
            TextSizeProperty,
            RowHeightProperty);
    }

    /// <summary>Color of the text.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    /// <summary>Color of the line numbers.</summary>
    public IBrush? NumberInk
    {
        get => GetValue(NumberInkProperty);
        set => SetValue(NumberInkProperty, value);
    }

    public IBrush? Ground
    {
        get => GetValue(GroundProperty);
        set => SetValue(GroundProperty, value);
    }

    /// <summary>Background of selected blocks.</summary>
    public IBrush? ChosenGround
    {
        get => GetValue(ChosenGroundProperty);
        set => SetValue(ChosenGroundProperty, value);
    }

    /// <summary>Color of the bar next to selected blocks.</summary>
    public IBrush? ChosenBrush
    {
        get => GetValue(ChosenBrushProperty);
        set => SetValue(ChosenBrushProperty, value);
    }

    public FontFamily FontFamily
    {
        get => GetValue(FontFamilyProperty);
        set => SetValue(FontFamilyProperty, value);
    }

    public double TextSize
    {
        get => GetValue(TextSizeProperty);
        set => SetValue(TextSizeProperty, value);
    }

    public double RowHeight
    {
        get => GetValue(RowHeightProperty);
        set => SetValue(RowHeightProperty, value);
    }

    /// <summary>Number of rows that exist.</summary>
    internal int RowsMade => _rows.Count;

    /// <summary>The blocks of existing rows whose text does not fit and ends in an ellipsis.</summary>
    internal IEnumerable<int> RowsCut => _rows.Where(r => r.Value.IsCut).Select(r => r.Key).Order();

    /// <summary>The end of the text in each existing row, from the left border.</summary>
    internal IEnumerable<(int Block, double End)> RowsEnd => _rows.Select(r => (r.Key, r.Value.End));

    /// <summary>Width of the line numbers and feature names, over which dragging selects.</summary>
    internal double Gutter => Math.Max(
        DrawnSizes.LeastGutter,
        DrawnSizes.TextBar + DrawnSizes.TextApart + _numberWidth + DrawnSizes.TextApart
            + (_nameWidth > 0 ? _nameWidth + DrawnSizes.TextApart : 0));

    /// <summary>Width of the visible part of a line.</summary>
    private protected double Room => Math.Max(1, Bounds.Width - Gutter - (2 * DrawnSizes.TextApart));

    /// <summary>Width of the longest line.</summary>
    private protected double LineWidth { get; private set; }

    private double Pixel => 1 / (TopLevel.GetTopLevel(this)?.RenderScaling ?? 1);

    /// <summary>Draws the background.</summary>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (Ground is { } ground)
        {
            context.FillRectangle(ground, new Rect(Bounds.Size));
        }
    }

    /// <summary>The words of the existing rows, each with its typeface.</summary>
    private protected IEnumerable<(string Words, Typeface Typeface)> WordsOf(OpenedProgram program) =>
    [
        .. _rows.Keys.SelectMany(b => new[] { Shown.Id(b + 1), program.LineAt(b) })
            .Append("…")
            .Select(w => (w, new Typeface(FontFamily))),
        .. _names.Keys.Select(n => (n, NameFace)),
    ];

    /// <summary>Draws the visible rows.</summary>
    /// <param name="context">Where to draw.</param>
    /// <param name="picture">The program; not empty.</param>
    /// <param name="offset">How far it is scrolled.</param>
    private protected void DrawRows(DrawingContext context, ProgramPicture picture, Vector offset)
    {
        var first = (int)(offset.Y / RowHeight);
        var last = Math.Min(picture.Program.Count - 1, (int)((offset.Y + Bounds.Height) / RowHeight));
        LetGo(first, last);
        for (var block = first; block <= last; block++)
        {
            Draw(context, picture, block, (block * RowHeight) - offset.Y, offset.X, block == first);
        }
    }

    /// <summary>Drops all rows, because they look different from now on or are not visible.</summary>
    private protected void Forget()
    {
        foreach (var row in _rows.Values)
        {
            row.Picture.Dispose();
        }

        _rows.Clear();
    }

    /// <summary>Drops all rows, and measures the line numbers, the names and the longest line again.</summary>
    private protected void MeasureRows(ProgramPicture? picture)
    {
        Forget();
        _names.Clear();
        (_numberWidth, _nameWidth, LineWidth) = (0, 0, 0);
        if (picture is null)
        {
            return;
        }

        LineWidth = picture.Program.LongestLine * Text("8", Ink).Width;
        _numberWidth = Text(new string('8', Shown.Id(picture.Program.Count).Length), NumberInk).Width;
        foreach (var mark in picture.Marks.Where(m => m.Ranges.Count > 0))
        {
            _names[mark.Name] = new(mark.Name, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, NameFace, TextSize, Ink)
            {
                MaxTextWidth = MostName * TextSize,
                MaxLineCount = 1,
                Trimming = TextTrimming.CharacterEllipsis
            };
            _nameWidth = Math.Max(_nameWidth, DrawnSizes.Near + _names[mark.Name].Width);
        }
    }

    private void Draw(DrawingContext context, ProgramPicture picture, int block, double top, double shift, bool isFirst)
    {
        if (picture.Selection is { } chosen && chosen.Contains(block))
        {
            context.FillRectangle(ChosenGround!, new Rect(0, top, Bounds.Width, RowHeight));
            context.FillRectangle(ChosenBrush!, new Rect(0, top, DrawnSizes.TextBar, RowHeight));
        }

        if (!_rows.TryGetValue(block, out var row))
        {
            _rows.Add(block, row = Make(picture.Program, block, shift));
        }

        // Aligned to whole pixels, so that it is copied and not resampled.
        context.DrawImage(
            row.Picture,
            new Rect(0, Math.Round(top / Pixel) * Pixel, row.Picture.PixelSize.Width * Pixel, row.Picture.PixelSize.Height * Pixel));
        var left = DrawnSizes.TextBar + DrawnSizes.TextApart + _numberWidth + DrawnSizes.TextApart;
        if (picture.FeatureOf(block) is { } name)
        {
            // A bar along all blocks of a feature, with its name at the first visible one.
            context.FillRectangle(Ink!, new Rect(left, top, DrawnSizes.FeatureBar, RowHeight));
            if ((isFirst || picture.FeatureOf(block - 1) != name) && _names.TryGetValue(name, out var shown))
            {
                context.DrawText(shown, new Point(left + DrawnSizes.Near, top + ((RowHeight - shown.Height) / 2)));
            }
        }
    }

    // Text is shaped and drawn once into a bitmap. Scrolling moves the bitmap, which takes a tenth of the time.
    private DrawnLine Make(OpenedProgram program, int block, double shift)
    {
        var (number, line) = (Text(Shown.Id(block + 1), NumberInk), Text(program.LineAt(block), Ink));

        // Cutting at a word boundary would make the line look complete.
        var room = Room + shift;
        var isCut = line.WidthIncludingTrailingWhitespace > room;
        if (isCut)
        {
            (line.MaxTextWidth, line.MaxLineCount, line.Trimming) = (room, 1, TextTrimming.CharacterEllipsis);
        }

        var end = Math.Max(Gutter, Gutter + DrawnSizes.TextApart + line.Width - shift);
        var width = Math.Clamp(end, 1, Math.Max(1, Bounds.Width));

        // The bitmap has the size in pixels, and the text is scaled here. For a bitmap with a higher DPI, some renderers take the
        // source rectangle in units, others in pixels.
        var row = new RenderTargetBitmap(new((int)Math.Ceiling(width / Pixel), (int)Math.Ceiling(RowHeight / Pixel)));
        using var context = row.CreateDrawingContext();
        using var scaled = context.PushTransform(Matrix.CreateScale(1 / Pixel, 1 / Pixel));
        context.DrawText(
            number, new Point(DrawnSizes.TextBar + DrawnSizes.TextApart + _numberWidth - number.Width, (RowHeight - number.Height) / 2));
        using var beside = context.PushClip(new Rect(Gutter, 0, Math.Max(0, width - Gutter), RowHeight));
        context.DrawText(line, new Point(Gutter + DrawnSizes.TextApart - shift, (RowHeight - line.Height) / 2));
        return new(row, isCut, end);
    }

    // Drops rows far out of sight.
    private void LetGo(int first, int last)
    {
        var seen = last - first + 1;
        if (_rows.Count > MostScreens * seen)
        {
            foreach (var block in _rows.Keys.Where(b => b < first || b > last).ToArray())
            {
                _rows.Remove(block, out var row);
                row?.Picture.Dispose();
            }
        }
    }

    private FormattedText Text(string text, IBrush? ink) =>
        new(text, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, new Typeface(FontFamily), TextSize, ink);

    /// <summary>A drawn row.</summary>
    /// <param name="Picture">Its line number and text.</param>
    /// <param name="IsCut">True if the text does not fit.</param>
    /// <param name="End">The end of its text, from the left border.</param>
    private sealed record DrawnLine(RenderTargetBitmap Picture, bool IsCut, double End);
}
