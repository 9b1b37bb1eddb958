using System.ComponentModel;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>The text of a program, one block per row; only visible rows are created. A tap selects a block. Dragging over the
/// line numbers, or anywhere with a mouse, selects all blocks on the way.</summary>
/// <remarks>It scrolls within a <see cref="ScrollViewer"/>. Keys: left and right scroll to text that does not fit; up, down,
/// page, Home and End select another block, with Shift they extend the selection; Enter assigns the selection to the feature that
/// blocks are picked for.</remarks>
public sealed partial class ProgramText : ProgramRows, IDrawnWords
{
    public static readonly StyledProperty<ProgramPicture?> PictureProperty = AvaloniaProperty.Register<ProgramText, ProgramPicture?>(
        nameof(Picture));

    static ProgramText()
    {
        FocusableProperty.OverrideDefaultValue<ProgramText>(true);
        ClipToBoundsProperty.OverrideDefaultValue<ProgramText>(true);
    }

    public ProgramPicture? Picture
    {
        get => GetValue(PictureProperty);
        set => SetValue(PictureProperty, value);
    }

    // The text of the current block, for screen readers.
    private string? Said => Picture is { Selection: not null } picture ? picture.Program.LineAt(picture.Cursor) : null;

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords =>
        Picture is not { Program: var program } ? [] : WordsOf(program);

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        base.Render(context);
        if (Picture is { Program.Count: > 0 } picture && Bounds.Height > 0)
        {
            DrawRows(context, picture, Offset);
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

    private void Follow(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName == nameof(ProgramPicture.Selection))
        {
            Show(Picture!.Cursor);
            DrawnPeer.Report(this, null, Said);
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

    private void Measure()
    {
        MeasureRows(Picture);
        AutomationProperties.SetHelpText(this, Picture?.Chosen ?? "");
        RaiseScrollInvalidated(EventArgs.Empty);
        InvalidateVisual();
    }
}
