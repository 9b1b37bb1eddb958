using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <content>Scrolling, and selecting by pointer, touch and keys.</content>
public sealed partial class ProgramText : ILogicalScrollable
{
    private const int WheelRows = 3;
    private const double FromAfarShare = 1.0 / 3;
    private const double RoundingShare = 0.000001;
    private static readonly TimeSpan ScrollEvery = TimeSpan.FromMilliseconds(40);

    private readonly DispatcherTimer _scrolling;
    private Vector _offset;
    private Point? _dragged;
    private string? _begun;

    public ProgramText() => _scrolling = new(ScrollEvery, DispatcherPriority.Input, (_, _) => DragOn());

    /// <inheritdoc/>
    public event EventHandler? ScrollInvalidated;

    /// <inheritdoc/>
    public bool CanHorizontallyScroll { get; set; }

    /// <inheritdoc/>
    public bool CanVerticallyScroll { get; set; }

    /// <inheritdoc/>
    public bool IsLogicalScrollEnabled => true;

    /// <inheritdoc/>
    public Size ScrollSize => new(WheelRows * RowHeight, WheelRows * RowHeight);

    /// <inheritdoc/>
    public Size PageScrollSize => new(Bounds.Width, Math.Max(RowHeight, Bounds.Height - RowHeight));

    /// <inheritdoc/>
    /// <remarks>The horizontal scroll bar covers a row: one extra row lets the last one scroll out from under it.</remarks>
    public Size Extent => new(Bounds.Width + Beyond, ((Picture?.Program.Count ?? 0) + (Beyond > 0 ? 1 : 0)) * RowHeight);

    /// <inheritdoc/>
    public Size Viewport => Bounds.Size;

    /// <inheritdoc/>
    public Vector Offset
    {
        get => _offset;
        set
        {
            var to = new Vector(Math.Clamp(value.X, 0, Beyond), Math.Clamp(value.Y, 0, Math.Max(0, Extent.Height - Bounds.Height)));
            if (to != _offset)
            {
                if (to.X != _offset.X)
                {
                    Forget();
                }

                _offset = to;
                RaiseScrollInvalidated(EventArgs.Empty);
                InvalidateVisual();
            }
        }
    }

    // How far the longest line extends beyond the right border; line numbers and names do not scroll sideways.
    private double Beyond => CanHorizontallyScroll ? Math.Max(0, LineWidth - Room) : 0;

    private int RowsSeen => Math.Max(1, (int)(Bounds.Height / RowHeight));

    /// <inheritdoc/>
    public bool BringIntoView(Control target, Rect targetRect) => false;

    /// <inheritdoc/>
    public Control? GetControlInDirection(NavigationDirection direction, Control? from) => null;

    /// <inheritdoc/>
    public void RaiseScrollInvalidated(EventArgs e) => ScrollInvalidated?.Invoke(this, e);

    /// <inheritdoc/>
    protected override Size MeasureOverride(Size availableSize) =>
        new(
            double.IsFinite(availableSize.Width) ? availableSize.Width : 0,
            double.IsFinite(availableSize.Height) ? availableSize.Height : 0);

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        base.OnSizeChanged(e);
        Forget();
        Offset = _offset;
        RaiseScrollInvalidated(EventArgs.Empty);
        ShowFeature();
    }

    /// <inheritdoc/>
    protected override void OnPointerPressed(PointerPressedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerPressed(e);
        Focus();
        var at = e.GetPosition(this);

        // A finger on the text scrolls, and selects a block when lifted. On the line numbers it selects, as a mouse does everywhere.
        if (e.Pointer.Type == PointerType.Mouse || at.X < Gutter)
        {
            _dragged = at;
            e.Pointer.Capture(this);
            e.PreventGestureRecognition();
            e.Handled = true;
            Pick(at, isExtending: e.KeyModifiers.HasFlag(KeyModifiers.Shift));
        }
    }

    /// <inheritdoc/>
    protected override void OnPointerMoved(PointerEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerMoved(e);
        if (_dragged is null)
        {
            return;
        }

        _dragged = e.GetPosition(this);
        _scrolling.IsEnabled = _dragged.Value.Y < 0 || _dragged.Value.Y > Bounds.Height;
        DragOn();
        e.Handled = true;
    }

    /// <inheritdoc/>
    protected override void OnPointerReleased(PointerReleasedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnPointerReleased(e);
        EndDrag();
    }

    /// <inheritdoc/>
    protected override void OnPointerCaptureLost(PointerCaptureLostEventArgs e)
    {
        base.OnPointerCaptureLost(e);
        EndDrag();
    }

    /// <inheritdoc/>
    protected override void OnInitialized()
    {
        base.OnInitialized();
        AddHandler(InputElement.TappedEvent, (_, e) =>
        {
            if (e.Pointer.Type != PointerType.Mouse && e.GetPosition(this) is var at && at.X >= Gutter)
            {
                Pick(at, isExtending: false);
            }
        });
    }

    /// <inheritdoc/>
    protected override void OnKeyDown(KeyEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnKeyDown(e);
        if (Picture is not { Program.Count: var count } picture || (e.KeyModifiers & ~KeyModifiers.Shift) != KeyModifiers.None)
        {
            return;
        }

        if (e.Key is Key.Left or Key.Right && e.KeyModifiers == KeyModifiers.None && Beyond > 0)
        {
            Offset += new Vector((e.Key == Key.Left ? -1 : 1) * ScrollSize.Width, 0);
            e.Handled = true;
            return;
        }

        int? lines = e.Key switch
        {
            Key.Up => -1,
            Key.Down => 1,
            Key.PageUp => -RowsSeen,
            Key.PageDown => RowsSeen,
            Key.Home => -count,
            Key.End => count,
            _ => null
        };
        if (lines is { } by)
        {
            picture.Move(by, e.KeyModifiers == KeyModifiers.Shift);
            e.Handled = true;
        }
        else if (e.Key == Key.Enter && picture.Take.CanExecute(null))
        {
            picture.Take.Execute(null);
            e.Handled = true;
        }
    }

    // While the finger is beyond the border, the text scrolls, faster with distance.
    private void DragOn()
    {
        if (_dragged is not { } at)
        {
            return;
        }

        Offset += new Vector(0, at.Y < 0 ? at.Y : Math.Max(0, at.Y - Bounds.Height));
        Pick(new(at.X, Math.Clamp(at.Y, 0, Bounds.Height - 1)), isExtending: true);
    }

    private void EndDrag()
    {
        _dragged = null;
        _scrolling.Stop();
    }

    private void Pick(Point at, bool isExtending)
    {
        var block = (int)((Offset.Y + at.Y) / RowHeight);
        if (isExtending && Picture?.Selection is not null)
        {
            Picture.Extend(block);
        }
        else
        {
            Picture?.Light(block);
        }
    }

    // Rounded to a whole row, so that the first row is never cut off.
    private void BeginWith(double top) => Offset = Offset.WithY(Math.Ceiling((top / RowHeight) - RoundingShare) * RowHeight);

    // Scrolls a block into view: from nearby by the least distance, from afar to a third of the height from the top.
    private void Show(int block)
    {
        var (top, height) = (block * RowHeight, Bounds.Height);
        if (_dragged is null && Picture?.Selection is not null && (top < Offset.Y || top + RowHeight > Offset.Y + height))
        {
            var away = Math.Min(Math.Abs(top - Offset.Y), Math.Abs(top + RowHeight - Offset.Y - height));
            BeginWith(away > 2 * RowHeight ? top - (FromAfarShare * height) : top < Offset.Y ? top : top + RowHeight - height);
        }

        AutomationProperties.SetHelpText(this, Picture?.Chosen ?? "");
    }

    // All of the blocks centered, or as many as fit, with one neighboring block.
    private void Show(FeatureLook look)
    {
        var (top, bottom, height) = ((look.Blocks.First - 1) * RowHeight, (look.Blocks.Last + 2) * RowHeight, Bounds.Height);
        BeginWith(bottom - top <= height ? (top + bottom - height) / 2 : look.IsAtEnd ? bottom - height : top);
        _begun = look.Feature;
        Picture!.TellRoom(isWhole: bottom - top <= height);
    }

    // Scrolls to the blocks of the feature to pick for, once they are known, unless they are visible or others are selected.
    private void ShowFeature()
    {
        if (Picture is { Selection: null, Feature: { } feature } picture && feature != _begun && Bounds.Height > 0
            && picture.Marks.FirstOrDefault(m => m.Name == feature) is { Ranges: [{ First: var first }, ..] })
        {
            _begun = feature;
            if (picture.Look is { } look && look.Feature == feature)
            {
                // The control was recreated, for example for another language: it restores the last request.
                Show(look);
                return;
            }

            var top = first * RowHeight;
            if (top < Offset.Y || top + RowHeight > Offset.Y + Bounds.Height)
            {
                BeginWith(top - (FromAfarShare * Bounds.Height));
            }
        }
    }
}
