using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Data;

namespace ErrorMatching.Hmi;

/// <summary>The area for messages. Its size is fixed, so messages never move a button. A longer message scrolls by finger, wheel
/// or keys.</summary>
internal sealed class SaidStrip : ScrollViewer
{
    // Less than this is rounding.
    private const double Least = 1;

    /// <summary>An empty area.</summary>
    public SaidStrip()
    {
        Classes.Add("strip");
        HorizontalScrollBarVisibility = ScrollBarVisibility.Disabled;
        this[!AutomationProperties.NameProperty] = (BindingBase)new TextExtension("Shell.Said").ProvideValue(null!);
    }

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(ScrollViewer);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == ExtentProperty || change.Property == ViewportProperty)
        {
            // A tab stop only if there is something to scroll.
            Focusable = Extent.Height >= Viewport.Height + Least;
        }
    }
}
