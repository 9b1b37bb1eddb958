using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The headings above the fields of theoretical points.</summary>
internal sealed partial class CoordinateHead : UserControl
{
    public static readonly StyledProperty<bool> HasZProperty = AvaloniaProperty.Register<CoordinateHead, bool>(nameof(HasZ));

    public CoordinateHead() => InitializeComponent();

    public bool HasZ
    {
        get => GetValue(HasZProperty);
        set => SetValue(HasZProperty, value);
    }
}
