using Avalonia.Controls;
using Avalonia.Input;
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

    // Enter confirms once everything is there; before that it goes on to what is missing.
    private void OnReasonKey(object? sender, KeyEventArgs e)
    {
        if (e.Key == Key.Enter && DataContext is SigningViewModel { NeedsPassword: true } signing && !signing.Confirm.CanExecute(null))
        {
            PasswordBox.Focus();
            e.Handled = true;
        }
    }
}
