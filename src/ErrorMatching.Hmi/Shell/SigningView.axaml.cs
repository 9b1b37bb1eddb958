using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Where somebody signs.</summary>
public sealed partial class SigningView : UserControl
{
    /// <summary>The view.</summary>
    public SigningView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);
        if (DataContext is SigningViewModel { NeedsReason: true })
        {
            ReasonBox.Focus();
        }
        else
        {
            PasswordBox.Focus();
        }
    }
}
