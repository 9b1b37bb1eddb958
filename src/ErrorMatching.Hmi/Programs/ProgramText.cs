using System.ComponentModel;
using System.Globalization;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Imaging;

namespace ErrorMatching.Hmi;

/// <summary>The text of a program, one block per row; only visible rows are created. A tap selects a block. Dragging over the
/// line numbers, or anywhere with a mouse, selects all blocks on the way.</summary>
/// <remarks>It scrolls within a <see cref="ScrollViewer"/>. Keys: left and right scroll to text that does not fit; up, down,
/// page, Home and End select another block, with Shift they extend the selection; Enter assigns the selection to the feature that
/// blocks are picked for.</remarks>
public sealed partial class ProgramText : Control, IDrawnWords
{
    public static readonly StyledProperty<ProgramPicture?> PictureProperty = AvaloniaProperty.Register<ProgramText, ProgramPicture?>(
        nameof(Picture));

    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<ProgramText, IBrush?>(nameof(Ink));

    public static readonly StyledProperty<IBrush?> NumberInkProperty = AvaloniaProperty.Register<ProgramText, IBrush?>(nameof(NumberInk));

    public static readonly StyledProperty<IBrush?> GroundProperty = AvaloniaProperty.Register<ProgramText, IBrush?>(nameof(Ground));

    public static readonly StyledProperty<IBrush?> ChosenGroundProperty = AvaloniaProperty.Register<ProgramText, IBrush?>(
        nameof(ChosenGround));

    public static readonly StyledProperty<IBrush?> ChosenBrushProperty = AvaloniaProperty.Register<ProgramText, IBrush?>(
        nameof(ChosenBrush));

    public static readonly StyledProperty<FontFamily> FontFamilyProperty = AvaloniaProperty.Register<ProgramText, FontFamily>(
        nameof(FontFamily), FontFamily.Default);

    public static readonly StyledProperty<double> TextSizeProperty = AvaloniaProperty.Register<ProgramText, double>(nameof(TextSize), 1);

    public static readonly StyledProperty<double> RowHeightProperty = AvaloniaProperty.Register<ProgramText, double>(nameof(RowHeight), 1);

    private static readonly Typeface NameFace = new(FontFamily.Default, FontStyle.Normal, FontWeight.SemiBold);
    private readonly Dictionary<int, DrawnLine> _rows = [];
    private readonly Dictionary<string, FormattedText> _names = [];
    private double _numberWidth, _nameWidth, _lineWidth;

    static ProgramText()
    {
        AffectsRender<ProgramText>(
            InkProperty,
            NumberInkProperty,
            GroundProperty,
            ChosenGroundProperty,
            ChosenBrushProperty,
            FontFamilyProperty,
            TextSizeProperty,
            RowHeightProperty);
        FocusableProperty.OverrideDefaultValue<ProgramText>(true);
        ClipToBoundsProperty.OverrideDefaultValue<ProgramText>(true);
    }

    public ProgramPicture? Picture
    {
        get => GetValue(PictureProperty);
        set => SetValue(PictureProperty, value);
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

    private double Pixel => 1 / (TopLevel.GetTopLevel(this)?.RenderScaling ?? 1);

    // The text of the current block, for screen readers.
    private string? Said => Picture is { Selection: not null } picture ? picture.Program.LineAt(picture.Cursor) : null;

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

    // Width of the visible part of a line.
    private double Room => Math.Max(1, Bounds.Width - Gutter - (2 * DrawnSizes.TextApart));

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords => Picture is not { Program: var program } ? []
        : [
            .. _rows.Keys.SelectMany(b => new[] { Shown.Id(b + 1), program.LineAt(b) })
                .Append("…")
                .Select(w => (w, new Typeface(FontFamily))),
            .. _names.Keys.Select(n => (n, NameFace))];

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (Ground is { } ground)
        {
            context.FillRectangle(ground, new Rect(Bounds.Size));
        }

        if (Picture is not { Program: var program } picture || program.Count == 0 || Bounds.Height <= 0)
        {
            return;
        }

        var first = (int)(Offset.Y / RowHeight);
        var last = Math.Min(program.Count - 1, (int)((Offset.Y + Bounds.Height) / RowHeight));
        LetGo(first, last);
        for (var block = first; block <= last; block++)
        {
            Draw(context, picture, block, (block * RowHeight) - Offset.Y, block == first);
        }
    }

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new DrawnPeer(this, AutomationControlType.Document, () => Said);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == PictureProperty)
        {
            if (change.OldValue is ProgramPicture old)
            {
                old.PropertyChanged -= Follow;
            }

            if (change.NewValue is ProgramPicture picture && TopLevel.GetTopLevel(this) is not null)
            {
                picture.PropertyChanged += Follow;
            }

            (Offset, _begun) = (default, null);
        }

        if (change.Property == PictureProperty
            || change.Property == InkProperty
            || change.Property == NumberInkProperty
            || change.Property == FontFamilyProperty
            || change.Property == TextSizeProperty
            || change.Property == RowHeightProperty)
        {
            Measure();
        }
    }

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        if (Picture is { } picture)
        {
            picture.PropertyChanged -= Follow;
            picture.PropertyChanged += Follow;

            // Changes made while the control was not on the screen were not followed; read them now.
            Measure();
            ShowFeature();
        }
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        _scrolling.Stop();
        Forget();
        if (Picture is { } picture)
        {
            picture.PropertyChanged -= Follow;
        }
    }

    private void Draw(DrawingContext context, ProgramPicture picture, int block, double top, bool isFirst)
    {
        if (picture.Selection is { } chosen && chosen.Contains(block))
        {
            context.FillRectangle(ChosenGround!, new Rect(0, top, Bounds.Width, RowHeight));
            context.FillRectangle(ChosenBrush!, new Rect(0, top, DrawnSizes.TextBar, RowHeight));
        }

        if (!_rows.TryGetValue(block, out var row))
        {
            _rows.Add(block, row = Make(picture.Program, block));
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
    private DrawnLine Make(OpenedProgram program, int block)
    {
        var (number, line) = (Text(Shown.Id(block + 1), NumberInk), Text(program.LineAt(block), Ink));

        // Cutting at a word boundary would make the line look complete.
        var room = Room + Offset.X;
        var isCut = line.WidthIncludingTrailingWhitespace > room;
        if (isCut)
        {
            (line.MaxTextWidth, line.MaxLineCount, line.Trimming) = (room, 1, TextTrimming.CharacterEllipsis);
        }

        var end = Math.Max(Gutter, Gutter + DrawnSizes.TextApart + line.Width - Offset.X);
        var width = Math.Clamp(end, 1, Math.Max(1, Bounds.Width));

        // The bitmap has the size in pixels, and the text is scaled here. For a bitmap with a higher DPI, some renderers take the
        // source rectangle in units, others in pixels.
        var row = new RenderTargetBitmap(new((int)Math.Ceiling(width / Pixel), (int)Math.Ceiling(RowHeight / Pixel)));
        using var context = row.CreateDrawingContext();
        using var scaled = context.PushTransform(Matrix.CreateScale(1 / Pixel, 1 / Pixel));
        context.DrawText(
            number, new Point(DrawnSizes.TextBar + DrawnSizes.TextApart + _numberWidth - number.Width, (RowHeight - number.Height) / 2));
        using var beside = context.PushClip(new Rect(Gutter, 0, Math.Max(0, width - Gutter), RowHeight));
        context.DrawText(line, new Point(Gutter + DrawnSizes.TextApart - Offset.X, (RowHeight - line.Height) / 2));
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

    private void Follow(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName == nameof(ProgramPicture.Selection))
        {
            Show(Picture!.Cursor);
            DrawnPeer.Tell(this, null, Said);
        }
        else if (e.PropertyName is nameof(ProgramPicture.Marks) or null)
        {
            Measure();
            ShowFeature();
        }
        else if (e.PropertyName == nameof(ProgramPicture.Feature))
        {
            ShowFeature();
        }
        else if (e.PropertyName == nameof(ProgramPicture.Look))
        {
            Show(Picture!.Look!);
        }

        InvalidateVisual();
    }

    private void Forget()
    {
        foreach (var row in _rows.Values)
        {
            row.Picture.Dispose();
        }

        _rows.Clear();
    }

    private void Measure()
    {
        Forget();
        _names.Clear();
        (_numberWidth, _nameWidth, _lineWidth) = (0, 0, 0);
        if (Picture is { } picture)
        {
            _lineWidth = picture.Program.LongestLine * Text("8", Ink).Width;
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

        AutomationProperties.SetHelpText(this, Picture?.Chosen ?? "");
        RaiseScrollInvalidated(EventArgs.Empty);
        InvalidateVisual();
    }

    private FormattedText Text(string text, IBrush? ink) =>
        new(text, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, new Typeface(FontFamily), TextSize, ink);

    /// <summary>A drawn row.</summary>
    /// <param name="Picture">Its line number and text.</param>
    /// <param name="IsCut">True if the text does not fit.</param>
    /// <param name="End">The end of its text, from the left border.</param>
    private sealed record DrawnLine(RenderTargetBitmap Picture, bool IsCut, double End);
}
