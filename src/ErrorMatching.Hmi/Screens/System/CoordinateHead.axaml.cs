using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What stands over the fields of theoretical points.</summary>
public sealed partial class CoordinateHead : UserControl
{
    /// <summary>Identifies <see cref="HasZ"/>.</summary>
    public static readonly StyledProperty<bool> HasZProperty = AvaloniaProperty.Register<CoordinateHead, bool>(nameof(HasZ));

    /// <summary>The view.</summary>
    public CoordinateHead() => InitializeComponent();

    /// <summary>True if points have a third coordinate.</summary>
    public bool HasZ
    {
        get => GetValue(HasZProperty);
        set => SetValue(HasZProperty, value);
    }
}
