using System.ComponentModel;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

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

    // The password is gone when something did not work, and is what comes next whichever button was tapped.
    private void OnSigning(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(SigningViewModel.Message) && sender is SigningViewModel { Message: not null, NeedsPassword: true })
        {
            Dispatcher.UIThread.Post(() => PasswordBox.Focus(), DispatcherPriority.Background);
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
