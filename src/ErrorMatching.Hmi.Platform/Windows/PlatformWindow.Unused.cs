using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Platform;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Platform;
using Avalonia.Platform.Surfaces;
using Avalonia.Rendering.Composition;

namespace ErrorMatching.Hmi.Platform;

/// <content>Callbacks that are only stored, constant answers, and requests that a station's window ignores.</content>
internal abstract partial class PlatformWindow
{
    public IPlatformHandle? Handle { get; } = new PlatformHandle(0, "window");

    public IPlatformRenderSurface[] Surfaces { get; }

    public Compositor Compositor => Windowing.Compositor;

    public Action<RawInputEventArgs>? Input { get; set; }

    public Action<Size, WindowResizeReason>? Resized { get; set; }

    public Action? Activated { get; set; }

    public Action? Deactivated { get; set; }

    public Action? Closed { get; set; }

    public Action<Rect>? Paint { get; set; }

    public Action<double>? ScalingChanged { get; set; }

    public Action<WindowTransparencyLevel>? TransparencyLevelChanged { get; set; }

    public Action? LostFocus { get; set; }

    public Action<PixelPoint>? PositionChanged { get; set; }

    public Action<WindowState>? WindowStateChanged { get; set; }

    public Action? GotInputWhenDisabled { get; set; }

    public Func<WindowCloseReason, bool>? Closing { get; set; }

    public Action<bool>? ExtendClientAreaToDecorationsChanged { get; set; }

    public PixelPoint Position { get; private set; }

    public virtual WindowState WindowState { get; set; }

    public WindowTransparencyLevel TransparencyLevel => WindowTransparencyLevel.None;

    public AcrylicPlatformCompensationLevels AcrylicCompensationLevels => new(1, 1, 1);

    public Size? FrameSize => null;

    public Size MaxAutoSizeHint => ScreenSize.ToSize(RenderScaling);

    public bool WindowStateGetterIsUsable => false;

    public bool IsClientAreaExtendedToDecorations => false;

    public bool NeedsManagedDecorations => false;

    public PlatformRequestedDrawnDecoration RequestedDrawnDecorations => default;

    public Thickness ExtendedMargins => default;

    public Thickness OffScreenMargin => default;

    /// <summary>None: popups are drawn inside their window.</summary>
    public IPopupImpl? CreatePopup() => null;

    public virtual void SetCursor(ICursorImpl? cursor)
    {
    }

    public virtual void SetTitle(string? title)
    {
    }

    public void SetTransparencyLevelHint(IReadOnlyList<WindowTransparencyLevel> transparencyLevels)
    {
    }

    public virtual void SetFrameThemeVariant(PlatformThemeVariant? themeVariant)
    {
    }

    public void SetTopmost(bool value)
    {
    }

    public void SetParent(IWindowImpl? parent)
    {
    }

    public void SetEnabled(bool enable)
    {
    }

    public void SetWindowDecorations(WindowDecorations enabled)
    {
    }

    public void SetIcon(IWindowIconImpl? icon)
    {
    }

    public void ShowTaskbarIcon(bool value)
    {
    }

    public void CanResize(bool value)
    {
    }

    public void SetCanMinimize(bool value)
    {
    }

    public void SetCanMaximize(bool value)
    {
    }

    public void BeginMoveDrag(PointerPressedEventArgs e)
    {
    }

    public void BeginResizeDrag(WindowEdge edge, PointerPressedEventArgs e)
    {
    }

    public virtual void SetMinMaxSize(Size minSize, Size maxSize)
    {
    }

    public void SetExtendClientAreaToDecorationsHint(bool extendIntoClientAreaHint)
    {
    }

    public void SetExtendClientAreaTitleBarHeightHint(double titleBarHeight)
    {
    }
}
