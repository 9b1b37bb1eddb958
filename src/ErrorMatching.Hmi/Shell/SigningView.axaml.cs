using System.ComponentModel;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>The signing dialog.</summary>
internal sealed partial class SigningView : UserControl
{
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

        if (DataContext is SigningViewModel signing)
        {
            signing.PropertyChanged += OnSigning;
        }
    }

    /// <inheritdoc/>
    protected override void OnUnloaded(RoutedEventArgs e)
    {
        if (DataContext is SigningViewModel signing)
        {
            signing.PropertyChanged -= OnSigning;
        }

        base.OnUnloaded(e);
    }

    // After a failure the password is cleared and must be entered next, whichever button was tapped.
    private void OnSigning(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(SigningViewModel.Message) && sender is SigningViewModel { Message: not null, NeedsPassword: true })
        {
            Dispatcher.UIThread.Post(() => PasswordBox.Focus(), DispatcherPriority.Background);
        }
    }

    // Enter confirms if all fields are filled in; otherwise it moves to the missing one.
    private void OnReasonKey(object? sender, KeyEventArgs e)
    {
        if (e.Key == Key.Enter && DataContext is SigningViewModel { NeedsPassword: true } signing && !signing.Confirm.CanExecute(null))
        {
            PasswordBox.Focus();
            e.Handled = true;
        }
    }
}
