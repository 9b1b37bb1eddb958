using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Avalonia.Rendering.Composition;

namespace ErrorMatching.Hmi.Cairo;

/// <content>Callbacks that are only kept, answers that are always the same, and requests that a station's window does not heed.</content>
internal abstract partial class PlatformWindow
{
    /// <inheritdoc/>
    public IPlatformHandle? Handle { get; } = new PlatformHandle(0, "window");

    /// <inheritdoc/>
    public IPlatformRenderSurface[] Surfaces { get; }

    /// <inheritdoc/>
    public Compositor Compositor => Windowing.Compositor;

    /// <inheritdoc/>
    public Action<RawInputEventArgs>? Input { get; set; }

    /// <inheritdoc/>
    public Action<Size, WindowResizeReason>? Resized { get; set; }

    /// <inheritdoc/>
    public Action? Activated { get; set; }

    /// <inheritdoc/>
    public Action? Deactivated { get; set; }

    /// <inheritdoc/>
    public Action? Closed { get; set; }

    /// <inheritdoc/>
    public Action<Rect>? Paint { get; set; }

    /// <inheritdoc/>
    public Action<double>? ScalingChanged { get; set; }

    /// <inheritdoc/>
    public Action<WindowTransparencyLevel>? TransparencyLevelChanged { get; set; }

    /// <inheritdoc/>
    public Action? LostFocus { get; set; }

    /// <inheritdoc/>
    public Action<PixelPoint>? PositionChanged { get; set; }

    /// <inheritdoc/>
    public Action<WindowState>? WindowStateChanged { get; set; }

    /// <inheritdoc/>
    public Action? GotInputWhenDisabled { get; set; }

    /// <inheritdoc/>
    public Func<WindowCloseReason, bool>? Closing { get; set; }

    /// <inheritdoc/>
    public Action<bool>? ExtendClientAreaToDecorationsChanged { get; set; }

    /// <inheritdoc/>
    public PixelPoint Position { get; private set; }

    /// <inheritdoc/>
    public virtual WindowState WindowState { get; set; }

    /// <inheritdoc/>
    public WindowTransparencyLevel TransparencyLevel => WindowTransparencyLevel.None;

    /// <inheritdoc/>
    public AcrylicPlatformCompensationLevels AcrylicCompensationLevels => new(1, 1, 1);

    /// <inheritdoc/>
    public Size? FrameSize => null;

    /// <inheritdoc/>
    public Size MaxAutoSizeHint => ScreenSize.ToSize(RenderScaling);

    /// <inheritdoc/>
    public bool WindowStateGetterIsUsable => false;

    /// <inheritdoc/>
    public bool IsClientAreaExtendedToDecorations => false;

    /// <inheritdoc/>
    public bool NeedsManagedDecorations => false;

    /// <inheritdoc/>
    public PlatformRequestedDrawnDecoration RequestedDrawnDecorations => default;

    /// <inheritdoc/>
    public Thickness ExtendedMargins => default;

    /// <inheritdoc/>
    public Thickness OffScreenMargin => default;

    /// <summary>None: popups are drawn inside their window.</summary>
    public IPopupImpl? CreatePopup() => null;

    /// <inheritdoc/>
    public virtual void SetCursor(ICursorImpl? cursor)
    {
    }

    /// <inheritdoc/>
    public virtual void SetTitle(string? title)
    {
    }

    /// <inheritdoc/>
    public void SetTransparencyLevelHint(IReadOnlyList<WindowTransparencyLevel> transparencyLevels)
    {
    }

    /// <inheritdoc/>
    public void SetFrameThemeVariant(PlatformThemeVariant? themeVariant)
    {
    }

    /// <inheritdoc/>
    public void SetTopmost(bool value)
    {
    }

    /// <inheritdoc/>
    public void SetParent(IWindowImpl? parent)
    {
    }

    /// <inheritdoc/>
    public void SetEnabled(bool enable)
    {
    }

    /// <inheritdoc/>
    public void SetWindowDecorations(WindowDecorations enabled)
    {
    }

    /// <inheritdoc/>
    public void SetIcon(IWindowIconImpl? icon)
    {
    }

    /// <inheritdoc/>
    public void ShowTaskbarIcon(bool value)
    {
    }

    /// <inheritdoc/>
    public void CanResize(bool value)
    {
    }

    /// <inheritdoc/>
    public void SetCanMinimize(bool value)
    {
    }

    /// <inheritdoc/>
    public void SetCanMaximize(bool value)
    {
    }

    /// <inheritdoc/>
    public void BeginMoveDrag(PointerPressedEventArgs e)
    {
    }

    /// <inheritdoc/>
    public void BeginResizeDrag(WindowEdge edge, PointerPressedEventArgs e)
    {
    }

    /// <inheritdoc/>
    public void SetMinMaxSize(Size minSize, Size maxSize)
    {
    }

    /// <inheritdoc/>
    public void SetExtendClientAreaToDecorationsHint(bool extendIntoClientAreaHint)
    {
    }

    /// <inheritdoc/>
    public void SetExtendClientAreaTitleBarHeightHint(double titleBarHeight)
    {
    }
}
